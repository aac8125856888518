// SPDX-License-Identifier: Apache-2.0
// Reads GIFTI surfaces (www.nitrc.org/projects/gifti, "Geometry format", version 1.0): XML with one
// array of vertices and one of triangles, each as text or base64, packed or not.
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "model/base/letters.h"
#include "model/import/readers/cortical_name.h"
#include "model/import/readers/gifti_numbers.h"
#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/xml_tags.h"

namespace sline::model {

namespace {

/// Returns the text with which `rest` begins, blanks around it left out.
std::string_view textBefore(std::string_view rest) {
  constexpr std::string_view cdata = "<![CDATA[";
  TextCursor at(rest);
  at.skipSpace();
  std::string_view text = rest.substr(std::size_t(at.at() - rest.data()));
  if (text.starts_with(cdata))
    text = text.substr(cdata.size(), text.find("]]>", cdata.size()) - cdata.size());
  else
    text = text.substr(0, text.find('<'));
  while (!text.empty() && TextCursor::isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

class GiftiParser {
 public:
  explicit GiftiParser(const Source& source) : m_source(source) {}

  Result<RawMeshes> parse() {
    TRY(scan());
    const GiftiArray* points = firstOf("NIFTI_INTENT_POINTSET");
    const GiftiArray* triangles = firstOf("NIFTI_INTENT_TRIANGLE");
    if (!points || !triangles)
      return noSurface(points, triangles);
    RawMesh mesh;
    TRY(readPoints(*points, mesh));
    FaceList faces;
    TRY(readTriangles(*triangles, faces));
    place(*points, mesh);
    mesh.name = corticalName(m_source.file(), m_anatomy);
    return assemble(m_source, std::move(mesh), faces, BadFaces::areErrors, std::move(m_warnings));
  }

 private:
  std::string_view contentOf(const XmlTag& tag) const {
    return textBefore(m_source.text().substr(std::size_t(tag.end() - m_source.begin())));
  }

  Status scan() {
    // The document type that stands before the first element has no effect.
    const std::size_t root = m_source.text().find("<GIFTI");
    if (root == std::string_view::npos)
      return m_source.whole("has no element GIFTI", "Check that the file is a GIFTI file");
    XmlTags tags(m_source.text().substr(root));
    std::string_view key;
    bool ended = false;
    while (const std::optional<XmlTag> tag = tags.next()) {
      ended = ended || (tag->closing && tag->name == "GIFTI");
      if (tag->closing || tag->empty)
        continue;
      if (tag->name == "DataArray")
        m_arrays.push_back({*tag, tag->attribute("Intent"), {}, {}, {}, {}});
      else if (tag->name == "Name")
        key = contentOf(*tag);
      else if (tag->name == "Value" && key.starts_with("AnatomicalStructure"))
        m_anatomy.append(" ").append(contentOf(*tag));
      else if (!m_arrays.empty())
        takeContent(*tag, m_arrays.back());
    }
    if (tags.failure())
      return m_source.atLine(tags.failure(), "a tag is malformed, or the file ends within it");
    if (!ended)
      return m_source.atLine(m_source.end(), "the file ends before </GIFTI>");
    return Unit{};
  }

  void takeContent(const XmlTag& tag, GiftiArray& array) const {
    if (tag.name == "Data")
      array.data = contentOf(tag);
    else if (tag.name == "DataSpace")
      array.space = contentOf(tag);
    else if (tag.name == "TransformedSpace")
      array.toSpace = contentOf(tag);
    else if (tag.name == "MatrixData")
      array.matrix = contentOf(tag);
  }

  const GiftiArray* firstOf(std::string_view intent) {
    const GiftiArray* found = nullptr;
    std::size_t more = 0;
    for (const GiftiArray& array : m_arrays)
      if (array.intent == intent && found)
        ++more;
      else if (array.intent == intent)
        found = &array;
    if (more > 0)
      m_warnings.push_back(m_source.warning("holds " + std::to_string(more) +
                                            " further arrays of vertices or triangles, which are "
                                            "left out"));
    return found;
  }

  Error noSurface(const GiftiArray* points, const GiftiArray* triangles) const {
    if (points || triangles)
      return m_source.whole(std::string("holds ") + (points ? "vertices without triangles"
                                                            : "triangles without vertices"),
                            "Save the surface as one file (.surf.gii)");
    std::string held = m_arrays.empty() ? "no array" : std::string(m_arrays.front().intent);
    return m_source.whole("holds numbers of a surface's vertices (" + held + "), but no surface",
                          "Open the surface that they belong to (.surf.gii)");
  }

  Status readPoints(const GiftiArray& array, RawMesh& mesh) const {
    GiftiNumbers numbers(m_source, array);
    TRY(numbers.open());
    mesh.positions.resize(numbers.rows());
    return numbers.each([&](std::size_t row, int column, auto& values) {
      return values.number(numbers.type(), mesh.positions[row][column]);
    });
  }

  Status readTriangles(const GiftiArray& array, FaceList& faces) const {
    GiftiNumbers numbers(m_source, array);
    TRY(numbers.open());
    std::vector<Triangle> corners(numbers.rows());
    Status read = numbers.each([&](std::size_t row, int column, auto& values) {
      std::int64_t vertex = 0;
      const bool there = values.integer(numbers.type(), vertex);
      corners[row][std::size_t(column)] = indexFrom(vertex);
      return there;
    });
    faces.reserve(corners.size(), 3 * corners.size());
    for (const Triangle& triangle : corners) {
      for (const std::uint32_t vertex : triangle)
        faces.add(vertex, numbers.place());
      faces.close();
    }
    return read;
  }

  /// Places the vertices. They stay where the file has them, as other programs show them. Only from
  /// coordinates that are called unknown, a matrix that leads to the scanner's is followed; one
  /// that leads to an atlas would change the head's shape.
  void place(const GiftiArray& points, RawMesh& mesh) const {
    mesh.frame = Frame::ras;
    mesh.frameReason = "GIFTI is RAS";
    mesh.unitReason = "GIFTI is in millimetres";
    const bool known = !points.space.empty() && points.space != "NIFTI_XFORM_UNKNOWN";
    const bool toScanner = points.toSpace == "NIFTI_XFORM_SCANNER_ANAT" ||
                           points.toSpace == "NIFTI_XFORM_ALIGNED_ANAT";
    glm::dmat4 matrix(1.0);
    if (known || !toScanner || !matrixIn(points.matrix, matrix))
      return;
    mesh.frameReason = "GIFTI is RAS; moved to the scanner's by its matrix";
    for (glm::vec3& p : mesh.positions)
      p = glm::vec3(matrix * glm::dvec4(glm::dvec3(p), 1.0));
  }

  /// Reads a matrix row by row; false where it is none or mirrors, as no way to the scanner's
  /// coordinates does.
  static bool matrixIn(std::string_view text, glm::dmat4& matrix) {
    TextCursor at(text);
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        at.skipSpace();
        if (!at.number(matrix[column][row]))
          return false;
      }
    return isFinite(matrix) && glm::determinant(glm::dmat3(matrix)) > 0.0;
  }

  const Source& m_source;
  std::vector<GiftiArray> m_arrays;
  std::string m_anatomy;
  std::vector<ImportWarning> m_warnings;
};

}  // namespace

Result<RawMeshes> readGifti(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return GiftiParser(source).parse();
}

bool isGiftiAnatomy(const std::filesystem::path& file) {
  std::filesystem::path name = file.filename();
  if (equalsIgnoringCase(name.extension().string(), ".gz"))
    name.replace_extension();
  const std::string kind = name.stem().extension().string();
  for (const char* other : {".label", ".shape", ".func", ".time", ".rgba", ".coord", ".topo"})
    if (equalsIgnoringCase(kind, other))
      return false;
  return isCalledAnatomical(file);
}

}  // namespace sline::model
