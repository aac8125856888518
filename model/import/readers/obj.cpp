// SPDX-License-Identifier: Apache-2.0
// Reads Wavefront OBJ: vertices and faces; groups and objects become surfaces of their own.
// Normals, texture coordinates, colours and materials are not read.
#include <array>

#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {
/// Describes a run of faces below one `g` or `o` statement.
struct ObjGroup {
  std::string name;
  std::string object;  ///< the enclosing `o`, where the name belongs to a `g`
  std::size_t firstFace = 0;
};

class ObjParser {
 public:
  explicit ObjParser(const Source& source) : m_source(source), m_at(source.text()) {}

  Result<RawMeshes> parse() {
    if (isOfMni())
      return m_source.whole("is a surface of the MNI's programs (.obj), not a Wavefront OBJ",
                            "Convert it to PLY, VTK or a Wavefront OBJ");
    if (m_source.text().starts_with("\xef\xbb\xbf"))
      m_at.moveTo(m_source.begin() + 3);
    m_groups.push_back({});
    while (!m_at.atEnd()) {
      m_at.skipBlanks();
      TRY(readStatement());
    }
    return surfaces();
  }

 private:
  /// Tells whether the file begins as the MNI's do: P for polygons, five properties of a surface
  /// and the number of points.
  bool isOfMni() const {
    TextCursor at(m_source.text());
    if (at.word() != "P")
      return false;
    double number = 0.0;
    for (int i = 0; i < 6; ++i) {
      at.skipBlanks();
      if (!at.number(number))
        return false;
    }
    return true;
  }

  Status readStatement() {
    const char first = m_at.peek();
    if (m_at.atLineEnd() || first == '#')
      return skipComment();
    const char* place = m_at.at();
    const std::string_view keyword = m_at.word();
    Status status = Unit{};
    if (keyword == "v") {
      status = readVertex(place);
    } else if (keyword == "f" || keyword == "fo") {
      status = readFace(place);
    } else if (keyword == "g" || keyword == "o") {
      openGroup(keyword == "o");
      return status;
    } else if (keyword == "l" || keyword == "p") {
      ++m_linesAndPoints;
    } else if (!isKnown(keyword)) {
      if (m_unknown++ == 0)
        m_firstUnknown = place;
    }
    ++m_statements;
    skipStatement();
    return status;
  }

  Status skipComment() {
    const std::string_view comment = m_at.restOfLine();
    if (!m_frame && comment.size() > 9)
      m_frame = frameInText(comment);
    return Unit{};
  }

  /// Moves to the next line that does not continue this one.
  void skipStatement() {
    bool continued = true;
    while (continued) {
      m_at.skipLine();
      const char* end = m_at.at();
      while (end != m_source.begin() && TextCursor::isLineEnd(end[-1]))
        --end;
      continued = end != m_source.begin() && end[-1] == '\\' && !m_at.atEnd();
    }
  }

  static bool isKnown(std::string_view keyword) {
    static constexpr std::array known = {
        "vn",        "vt",       "vp",       "usemtl", "mtllib", "s",      "mg",
        "cstype",    "deg",      "bmat",     "step",   "curv",   "curv2",  "surf",
        "parm",      "trim",     "hole",     "scrv",   "sp",     "end",    "con",
        "bevel",     "c_interp", "d_interp", "lod",    "maplib", "usemap", "shadow_obj",
        "trace_obj", "ctech",    "stech",    "call",   "csh",    "vc"};
    return std::find(known.begin(), known.end(), keyword) != known.end();
  }

  Status readVertex(const char* place) {
    glm::vec3 p(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      m_at.skipBlanks();
      if (!m_at.number(p[axis]))
        return m_source.atLine(
            place, m_at.atLineEnd()
                       ? "a vertex needs three numbers, this one has " + std::to_string(axis)
                       : inQuotes(m_at.peekWord()) + " is not a number");
    }
    m_positions.push_back(p);
    return Unit{};
  }

  Status readFace(const char* place) {
    int corners = 0;
    for (m_at.skipBlanks(); !m_at.atLineEnd() && m_at.peek() != '#'; m_at.skipBlanks()) {
      std::int64_t index = 0;
      if (!m_at.integer(index))
        return m_source.atLine(place, inQuotes(m_at.peekWord()) + " is not a vertex of a face");
      // Texture and normal references follow after slashes.
      while (!m_at.atLineEnd() && !TextCursor::isBlank(m_at.peek()) && m_at.peek() != '\\') {
        const char c = m_at.peek();
        if (c != '/' && c != '-' && (c < '0' || c > '9'))
          return m_source.atLine(place, inQuotes(m_at.peekWord()) + " is not a vertex of a face");
        m_at.moveTo(m_at.at() + 1);
      }
      m_faces.add(resolved(index), place);
      ++corners;
    }
    if (corners < 3 && m_at.atEnd())
      return m_source.atLine(place, "the file ends within a face");
    m_faces.close();
    return Unit{};
  }

  /// Resolves an index: 1 is the first vertex, −1 the latest one.
  std::uint32_t resolved(std::int64_t index) const {
    if (index > 0)
      return indexFrom(index - 1);
    return index == 0 ? noVertex : indexFrom(std::int64_t(m_positions.size()) + index);
  }

  void openGroup(bool isObject) {
    const std::string name(m_at.restOfLine());
    if (isObject)
      m_object = name;
    // There is nothing between two statements: the earlier one named nothing.
    if (m_groups.back().firstFace == m_faces.size())
      m_groups.pop_back();
    m_groups.push_back({name, isObject ? std::string() : m_object, m_faces.size()});
  }

  Result<RawMeshes> surfaces() {
    if (m_unknown > 0 && (m_unknown * 100 >= m_statements || m_positions.empty()))
      return m_source.atLine(m_firstUnknown, "this is not a statement of an OBJ file",
                             "Check that the file is an OBJ file");
    RawMeshes result;
    addWarnings(result);
    CutTally tally;
    std::vector<std::uint32_t> scratch;
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
      const bool last = i + 1 == m_groups.size();
      RawMesh mesh = opened(m_groups[i]);
      cutFaces({m_faces, m_groups[i].firstFace, last ? m_faces.size() : m_groups[i + 1].firstFace},
               m_positions, mesh.triangles, tally);
      if (mesh.triangles.empty())
        continue;
      keepUsed(m_positions, scratch, mesh);
      TRY(finish(m_source, std::move(mesh), result));
    }
    TRY(judge(m_source, m_faces, tally, BadFaces::fewAreDropped, result.warnings));
    if (result.meshes.empty())
      return m_source.whole(reasonWithoutFaces(), "Export the mesh as a surface with faces");
    return result;
  }

  RawMesh opened(const ObjGroup& group) const {
    RawMesh mesh;
    mesh.name = group.name;
    if (!group.object.empty() && group.object != group.name)
      mesh.groups.push_back(group.object);
    if (m_frame) {
      mesh.frame = m_frame;
      mesh.frameReason = "SPACE in a comment";
    }
    return mesh;
  }

  void addWarnings(RawMeshes& result) const {
    if (m_linesAndPoints > 0)
      result.warnings.push_back(
          m_source.warning(std::to_string(m_linesAndPoints) +
                           " line and point elements are left out; only faces are read"));
    if (m_unknown > 0)
      result.warnings.push_back(m_source.warning(
          std::to_string(m_unknown) + " statements are unknown and left out (the first: " +
          m_source.atLine(m_firstUnknown, {}).where + ")"));
  }

  std::string reasonWithoutFaces() const {
    if (m_positions.empty())
      return "holds no vertices";
    if (m_linesAndPoints > 0)
      return "holds no faces, only lines or points";
    return m_faces.size() == 0 ? "holds vertices but no faces" : "holds no triangles";
  }

  const Source& m_source;
  TextCursor m_at;
  std::vector<glm::vec3> m_positions;
  FaceList m_faces;
  std::vector<ObjGroup> m_groups;
  std::string m_object;
  std::optional<Frame> m_frame;
  std::size_t m_statements = 0;
  std::size_t m_linesAndPoints = 0;
  std::size_t m_unknown = 0;
  const char* m_firstUnknown = nullptr;
};
}  // namespace

Result<RawMeshes> readObj(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return ObjParser(source).parse();
}

}  // namespace sline::model
