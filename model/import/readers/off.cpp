// SPDX-License-Identifier: Apache-2.0
// Reads Geomview OFF as text, with the prefixes ST, C and N (texture coordinates, colours and
// normals are skipped). There is one vertex or face a line; # begins a comment.
#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {
class OffParser {
 public:
  explicit OffParser(const Source& source) : m_source(source), m_at(source.text()) {}

  Result<RawMeshes> parse() {
    TRY(readHeader());
    TRY(readVertices());
    TRY(readFaces());
    return assemble(m_source, std::move(m_mesh), m_faces, BadFaces::fewAreDropped);
  }

 private:
  /// Moves to the next line that has content.
  void toContent() {
    m_at.skipSpace();
    while (m_at.peek() == '#') {
      const std::string_view comment = m_at.restOfLine();
      if (!m_mesh.frame && (m_mesh.frame = frameInText(comment)))
        m_mesh.frameReason = "SPACE in a comment";
      m_at.skipSpace();
    }
  }

  Status readHeader() {
    toContent();
    const char* place = m_at.at();
    std::string_view word = m_at.word();
    const std::string keyword(word);
    for (const std::string_view prefix : {"ST", "C", "N"})
      if (word.starts_with(prefix))
        word.remove_prefix(prefix.size());
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
      return m_source.atLine(place,
                             inQuotes(keyword) + " holds points of other than three dimensions",
                             "Export a surface in three dimensions");
    if (word != "OFF")
      return m_source.atLine(place, "the file does not begin with 'OFF'",
                             "Check that the file is an OFF file");
    m_at.skipBlanks();
    if (m_at.peekWord() == "BINARY")
      return m_source.atLine(place, "binary OFF is not supported", "Export the mesh as text OFF");
    return readCounts();
  }

  Status readCounts() {
    toContent();
    const char* place = m_at.at();
    if (!m_at.integer(m_vertices))
      return m_source.atLine(place, "the number of vertices is missing");
    m_at.skipBlanks();
    if (!m_at.integer(m_faceCount))
      return m_source.atLine(place, "the number of faces is missing");
    m_at.skipLine();
    // A vertex takes six bytes ("0 0 0\n") and a face four ("1 0\n"), the last one less a line end.
    const std::uint64_t left = std::uint64_t(m_at.end() - m_at.at()) + 1;
    if (m_vertices < 0 || std::uint64_t(m_vertices) > left / 6)
      return tooMany(place, m_vertices, "vertices");
    if (m_faceCount < 0 || std::uint64_t(m_faceCount) > left / 2)
      return tooMany(place, m_faceCount, "faces");
    return Unit{};
  }

  Error tooMany(const char* place, std::int64_t count, const char* what) const {
    return m_source.atLine(place, "promises " + std::to_string(count) + " " + what +
                                      ", more than a file of " + std::to_string(m_source.size()) +
                                      " bytes can hold");
  }

  Status readVertices() {
    m_mesh.positions.reserve(std::size_t(m_vertices));
    for (std::int64_t i = 0; i < m_vertices; ++i) {
      toContent();
      glm::vec3 p(0.0f);
      for (int axis = 0; axis < 3; ++axis) {
        m_at.skipBlanks();
        if (!m_at.number(p[axis]))
          return missing("vertices", i, m_vertices, "a coordinate");
      }
      m_mesh.positions.push_back(p);
      m_at.skipLine();
    }
    return Unit{};
  }

  Status readFaces() {
    m_faces.reserve(std::size_t(m_faceCount), 3 * std::size_t(m_faceCount));
    for (std::int64_t i = 0; i < m_faceCount; ++i) {
      toContent();
      const char* place = m_at.at();
      std::int64_t corners = 0;
      if (!m_at.integer(corners))
        return missing("faces", i, m_faceCount, "a number of corners");
      if (corners < 0 || corners > m_at.end() - m_at.at())
        return tooMany(place, corners, "corners");
      for (std::int64_t corner = 0; corner < corners; ++corner) {
        m_at.skipBlanks();
        std::int64_t index = 0;
        if (!m_at.integer(index))
          return missing("faces", i, m_faceCount, "the index of a vertex");
        m_faces.add(indexFrom(index), place);
      }
      m_faces.close();
      m_at.skipLine();
    }
    return Unit{};
  }

  Error missing(const char* what, std::int64_t done, std::int64_t promised,
                const char* expected) const {
    if (m_at.atEnd())
      return m_source.atLine(m_at.at(), "promises " + std::to_string(promised) + " " + what +
                                            ", the file ends after " + std::to_string(done));
    return m_source.atLine(
        m_at.at(), m_at.atLineEnd()
                       ? std::string("the line ends where ") + expected + " should follow"
                       : inQuotes(m_at.peekWord()) + " stands where " + expected + " should");
  }

  const Source& m_source;
  TextCursor m_at;
  std::int64_t m_vertices = 0;
  std::int64_t m_faceCount = 0;
  RawMesh m_mesh;
  FaceList m_faces;
};
}  // namespace

Result<RawMeshes> readOff(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return OffParser(source).parse();
}

}  // namespace sline::model
