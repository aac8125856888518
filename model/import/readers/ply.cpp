// SPDX-License-Identifier: Apache-2.0
// Reads PLY, text and binary of either byte order: the elements vertex, face and tristrips,
// whatever the order and type of their properties; other elements are stepped over.
#include "model/import/readers/ply_header.h"
#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {
/// Says which of a vertex's properties are x, y and z.
struct VertexLayout {
  std::size_t axis[3] = {SIZE_MAX, SIZE_MAX, SIZE_MAX};
  bool complete() const {
    return axis[0] != SIZE_MAX && axis[1] != SIZE_MAX && axis[2] != SIZE_MAX;
  }
};

VertexLayout layoutOf(const PlyElement& element) {
  VertexLayout layout;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!element.properties[i].countType &&
          element.properties[i].name == "xyz"[axis] + std::string())
        layout.axis[axis] = i;
  return layout;
}

std::size_t indexList(const PlyElement& element) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.countType &&
        (property.name == "vertex_indices" || property.name == "vertex_index"))
      return i;
  }
  return SIZE_MAX;
}

template <class Values>
class PlyBody {
 public:
  PlyBody(const Source& source, const PlyHeader& header, Values values)
      : m_source(source), m_header(header), m_values(values) {}

  Result<RawMeshes> read() {
    for (const PlyElement& element : m_header.elements)
      TRY(readElement(element));
    if (!m_hasVertices)
      return m_source.whole("has no element 'vertex'");
    if (!m_hasFaces)
      return m_source.whole("holds points but no element 'face' or 'tristrips'",
                            "Export the mesh as a surface with faces");
    if (m_header.frame) {
      m_mesh.frame = m_header.frame;
      m_mesh.frameReason = "SPACE in a comment";
    }
    return assemble(m_source, std::move(m_mesh), m_faces, BadFaces::fewAreDropped);
  }

 private:
  Status readElement(const PlyElement& element) {
    if (element.properties.empty())
      return Unit{};
    std::uint64_t atMost = UINT64_MAX;
    // This is the least that one record takes; a count above that is a lie and must not reserve
    // memory.
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += Values::text ? 2 : sizeOf(property.countType.value_or(property.type));
    atMost = m_values.atMost(ScalarType::uint8) * (Values::text ? 2 : 1) / bytes;
    if (element.count > atMost)
      return m_source.atLine(element.place,
                             "promises " + std::to_string(element.count) + " of '" + element.name +
                                 "', the rest of the file holds at most " + std::to_string(atMost));
    if (element.name == "vertex")
      return readVertices(element);
    if (element.name == "face" || element.name == "tristrips")
      return readFaces(element, element.name == "tristrips");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      m_values.beginRecord();
      for (const PlyProperty& property : element.properties)
        if (!skip(property))
          return broken(element, i);
      m_values.endRecord();
    }
    return Unit{};
  }

  bool skip(const PlyProperty& property) {
    std::uint64_t count = 1;
    return (!property.countType || readCount(property, count)) &&
           m_values.skip(property.type, count);
  }

  bool readCount(const PlyProperty& property, std::uint64_t& count) {
    std::int64_t value = 0;
    if (!m_values.integer(*property.countType, value) || value < 0)
      return false;
    count = std::uint64_t(value);
    return count <= m_values.atMost(property.type);
  }

  Status readVertices(const PlyElement& element) {
    const VertexLayout layout = layoutOf(element);
    if (!layout.complete())
      return m_source.atLine(element.place, "the vertices have no properties x, y and z");
    if (m_hasVertices)
      return m_source.atLine(element.place, "there are two elements 'vertex'");
    m_hasVertices = true;
    m_mesh.positions.resize(std::size_t(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      glm::vec3& p = m_mesh.positions[std::size_t(i)];
      m_values.beginRecord();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const bool isX = k == layout.axis[0];
        const bool isY = k == layout.axis[1];
        const bool good =
            isX || isY || k == layout.axis[2]
                ? m_values.number(element.properties[k].type, isX ? p.x : (isY ? p.y : p.z))
                : skip(element.properties[k]);
        if (!good)
          return broken(element, i);
      }
      m_values.endRecord();
    }
    return Unit{};
  }

  Status readFaces(const PlyElement& element, bool strips) {
    const std::size_t indices = indexList(element);
    if (indices == SIZE_MAX)
      return m_source.atLine(element.place,
                             "the element '" + element.name + "' has no list 'vertex_indices'");
    m_hasFaces = true;
    if (!strips)
      m_faces.reserve(std::size_t(element.count), 3 * std::size_t(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      m_values.beginRecord();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const bool good =
            k != indices ? skip(property) : (strips ? readStrip(property) : readFace(property));
        if (!good)
          return broken(element, i);
      }
      m_values.endRecord();
    }
    return Unit{};
  }

  bool readFace(const PlyProperty& property) {
    const char* place = m_values.at();
    std::uint64_t count = 0;
    if (!readCount(property, count))
      return false;
    for (; count > 0; --count) {
      std::int64_t index = 0;
      if (!m_values.integer(property.type, index))
        return false;
      m_faces.add(indexFrom(index), place);
    }
    m_faces.close();
    return true;
  }

  /// Reads strips; one list may hold several of them, −1 between them.
  bool readStrip(const PlyProperty& property) {
    const char* place = m_values.at();
    std::uint64_t count = 0;
    if (!readCount(property, count))
      return false;
    m_strip.clear();
    for (; count > 0; --count) {
      std::int64_t index = 0;
      if (!m_values.integer(property.type, index))
        return false;
      if (index == -1) {
        addStrip(m_strip, m_faces, place);
        m_strip.clear();
      } else {
        m_strip.push_back(indexFrom(index));
      }
    }
    addStrip(m_strip, m_faces, place);
    return true;
  }

  Error broken(const PlyElement& element, std::uint64_t done) const {
    const std::string of = std::to_string(done) + " of " + std::to_string(element.count) + " of '" +
                           element.name + "'";
    if constexpr (Values::text) {
      TextCursor at(m_values.at(), m_source.end());
      at.skipSpace();
      if (!at.atEnd())
        return m_source.atLine(
            at.at(),
            inQuotes(at.peekWord()) + " is not a value or count that fits there, after " + of);
      return m_source.atLine(m_source.end(), "the file ends after " + of);
    } else {
      return m_source.atByte(m_values.at(),
                             "the file ends, or a list is longer than it, after " + of);
    }
  }

  const Source& m_source;
  const PlyHeader& m_header;
  Values m_values;
  RawMesh m_mesh;
  FaceList m_faces;
  std::vector<std::uint32_t> m_strip;
  bool m_hasVertices = false;
  bool m_hasFaces = false;
};
}  // namespace

Result<RawMeshes> readPly(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  const PlyHeader header = TRY(readPlyHeader(source));
  if (header.binary)
    return PlyBody(source, header, BinaryValues(header.body, source.end(), *header.binary)).read();
  return PlyBody(source, header, TextValues(header.body, source.end())).read();
}

}  // namespace sline::model
