// SPDX-License-Identifier: Apache-2.0
// Reads VTK's XML PolyData: text, binary and appended arrays, compressed by VTK's own compressors.
// vtkXMLPolyDataReader is not used, because it reads string arrays through a null pointer when
// their element is damaged and makes room for whatever the last offset asks for.
#include "model/import/readers/vtk/vtk_readers.h"
#include "model/import/readers/vtk/vtp_document.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {
class VtpReader {
 public:
  VtpReader(const Source& source, const VtpDocument& document)
      : m_source(source), m_document(document) {}

  Result<RawMeshes> read() {
    std::vector<ImportWarning> warnings;
    for (const VtpPiece& piece : m_document.pieces) {
      TRY(readPiece(piece));
      if (piece.hasLines && warnings.empty())
        warnings.push_back(
            m_source.warning("Verts and Lines are left out; only polygons are read"));
    }
    takeFrame();
    return assemble(m_source, std::move(m_mesh), m_faces, BadFaces::areErrors, std::move(warnings));
  }

 private:
  Status readPiece(const VtpPiece& piece) {
    m_firstPoint = m_mesh.positions.size();
    Status status = readPoints(piece);
    if (status)
      status = readCells(piece, "Polys", piece.polys);
    if (status)
      status = readCells(piece, "Strips", piece.strips);
    return status;
  }

  /// Returns the array, once it is known to hold that many values.
  Result<const VtpArray*> arrayOf(const VtpPiece& piece, const std::string& section,
                                  const std::string& name, std::uint64_t values) const {
    for (const VtpArray& array : piece.arrays) {
      if (array.section != section || (!name.empty() && array.name != name))
        continue;
      const std::optional<std::uint64_t> held = valuesIn(m_document.encoding, array.content);
      if (!held)
        return m_source.atLine(array.place, "the block header of an array of " + section +
                                                " is broken or promises more than the file holds");
      if (*held < values)
        return m_source.atLine(array.place, section + " need " + std::to_string(values) +
                                                " values, the array holds at most " +
                                                std::to_string(*held));
      return &array;
    }
    return m_source.atLine(piece.place,
                           "a Piece promises " + section + " and has no array of them");
  }

  /// Calls read(values) on the array's first `count` values, text or binary.
  template <class Read>
  Status withValues(const VtpArray& array, std::uint64_t count, const Read& read) const {
    bool good = false;
    if (array.content.ascii) {
      const std::string_view text = array.content.text;
      TextValues values(text.data(), text.data() + text.size());
      good = read(values);
    } else if (const auto bytes = bytesOf(m_document.encoding, array.content, count)) {
      BinaryValues values(bytes->data(), bytes->data() + bytes->size(), m_document.encoding.order);
      good = read(values);
    }
    if (!good)
      return m_source.atLine(array.place,
                             "the values of an array of " + array.section + " cannot be decoded");
    return Unit{};
  }

  Status readPoints(const VtpPiece& piece) {
    if (piece.points == 0)
      return Unit{};
    const VtpArray* const array = TRY(arrayOf(piece, "Points", {}, 3 * piece.points));
    const ScalarType type = array->content.type;
    return withValues(*array, 3 * piece.points, [&](auto& values) {
      for (std::uint64_t i = 0; i < piece.points; ++i) {
        glm::vec3 p(0.0f);
        if (!values.number(type, p.x) || !values.number(type, p.y) || !values.number(type, p.z))
          return false;
        m_mesh.positions.push_back(p);
      }
      return true;
    });
  }

  Status readIntegers(const VtpArray& array, std::uint64_t count,
                      std::vector<std::int64_t>& integers) const {
    return withValues(array, count, [&](auto& values) {
      for (std::uint64_t i = 0; i < count; ++i) {
        std::int64_t value = 0;
        if (!values.integer(array.content.type, value))
          return false;
        integers.push_back(value);
      }
      return true;
    });
  }

  Status readCells(const VtpPiece& piece, const std::string& section, std::uint64_t count) {
    if (count == 0)
      return Unit{};
    const VtpArray* const offsetArray = TRY(arrayOf(piece, section, "offsets", count));
    std::vector<std::int64_t> offsets;
    Status status = readIntegers(*offsetArray, count, offsets);
    if (!status)
      return status;
    std::int64_t end = 0;
    for (const std::int64_t offset : offsets) {
      if (offset < end)
        return m_source.atLine(offsetArray->place, "the offsets of " + section + " fall");
      end = offset;
    }
    const VtpArray* const cornerArray =
        TRY(arrayOf(piece, section, "connectivity", std::uint64_t(end)));
    std::vector<std::int64_t> corners;
    status = readIntegers(*cornerArray, std::uint64_t(end), corners);
    if (status)
      addCells(offsets, corners, section == "Strips", cornerArray->place);
    return status;
  }

  void addCells(const std::vector<std::int64_t>& offsets, const std::vector<std::int64_t>& corners,
                bool strips, const char* place) {
    // An index beyond its own piece must not reach into the next one.
    const auto points = std::int64_t(m_mesh.positions.size() - m_firstPoint);
    std::vector<std::uint32_t> cell;
    std::size_t first = 0;
    for (const std::int64_t offset : offsets) {
      cell.clear();
      for (; first < std::size_t(offset); ++first) {
        const std::int64_t v = corners[first];
        cell.push_back(v >= 0 && v < points ? indexFrom(v + std::int64_t(m_firstPoint)) : noVertex);
      }
      if (strips) {
        addStrip(cell, m_faces, place);
        continue;
      }
      for (const std::uint32_t v : cell)
        m_faces.add(v, place);
      m_faces.close();
    }
  }

  /// Takes the frame from 3 characters and a zero, as numbers or bytes.
  void takeFrame() {
    if (!m_document.space)
      return;
    VtpContent content = *m_document.space;
    content.type = ScalarType::uint8;
    std::string name;
    const VtpArray array{"SPACE", {}, m_source.begin(), content};
    const bool good = bool(withValues(array, 3, [&](auto& values) {
      for (int i = 0; i < 3; ++i) {
        std::int64_t code = 0;
        if (!values.integer(ScalarType::uint8, code))
          return false;
        name += char(code & 0x7f);
      }
      return true;
    }));
    m_mesh.frame = good ? frameInText("SPACE=" + name) : std::nullopt;
    if (m_mesh.frame)
      m_mesh.frameReason = "SPACE in the field data";
  }

  const Source& m_source;
  const VtpDocument& m_document;
  RawMesh m_mesh;
  FaceList m_faces;
  std::size_t m_firstPoint = 0;
};
}  // namespace

Result<RawMeshes> readVtp(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  const VtpDocument document = TRY(scanVtp(source));
  return VtpReader(source, document).read();
}

}  // namespace sline::model
