// SPDX-License-Identifier: Apache-2.0
// Reads GIFTI surfaces (www.nitrc.org/projects/gifti, "Geometry format", version 1.0): XML with one
// array of vertices and one of triangles, each as text or base64, packed or not.
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "model/base/letters.h"
#include "model/import/readers/cortical_name.h"
#include "model/import/readers/readers.h"
#include "model/import/source/base64.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/xml_tags.h"

namespace sline::model {

namespace {

/// Describes one DataArray: pieces of the file.
struct GiftiArray {
  XmlTag tag;
  std::string_view intent;
  std::string_view data;
  std::string_view space;    ///< the space of the vertices
  std::string_view toSpace;  ///< the space to which the matrix leads
  std::string_view matrix;
};

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

std::optional<ScalarType> giftiType(std::string_view name) {
  if (name == "NIFTI_TYPE_FLOAT32")
    return ScalarType::float32;
  if (name == "NIFTI_TYPE_FLOAT64")
    return ScalarType::float64;
  if (name == "NIFTI_TYPE_INT32")
    return ScalarType::int32;
  if (name == "NIFTI_TYPE_UINT32")
    return ScalarType::uint32;
  if (name == "NIFTI_TYPE_UINT8")
    return ScalarType::uint8;
  return std::nullopt;
}

/// Reads the numbers of an array of three columns, wherever they are.
class GiftiNumbers {
 public:
  GiftiNumbers(const Source& source, const GiftiArray& array) : m_source(source), m_array(array) {}

  Status open() {
    if (const Status status = readShape(); !status)
      return status.error();
    const std::string_view encoding = m_array.tag.attribute("Encoding");
    if (encoding == "ASCII") {
      m_text = true;
      if (rows() > (m_array.data.size() + 1) / 2 / 3)
        return tooFew(m_array.data.size());
      return Unit{};
    }
    if (encoding == "ExternalFileBinary")
      return fault("has its numbers in a file of its own, which is not read",
                   "Convert it to GIFTI with base64, as wb_command -gifti-convert does");
    const bool packed = encoding == "GZipBase64Binary";
    if (!packed && encoding != "Base64Binary")
      return fault("has its numbers in an unknown encoding, " + inQuotes(encoding));
    std::optional<std::string> bytes = decodeBase64(m_array.data);
    if (!bytes)
      return fault("has data that are no base64");
    return packed ? unpack(*bytes) : take(std::move(*bytes));
  }

  std::size_t rows() const { return m_rows; }

  /// Calls put(row, column, values) for each number in the order of the file; `values` gives the
  /// number.
  template <class Put>
  Status each(const Put& put) {
    if (m_text)
      return eachOf(TextValues(m_array.data.data(), m_array.data.data() + m_array.data.size()),
                    put);
    const bool little = m_array.tag.attribute("Endian") != "BigEndian";
    return eachOf(BinaryValues(m_bytes.data(), m_bytes.data() + m_bytes.size(),
                               little ? std::endian::little : std::endian::big),
                  put);
  }

  ScalarType type() const { return m_type; }
  const char* place() const { return m_array.tag.begin(); }

 private:
  Status fault(const std::string& reason, std::string remedy = {}) const {
    return m_source.atLine(place(), "an array " + reason, std::move(remedy));
  }
  Status tooFew(std::uint64_t held) const {
    return fault("promises " + std::to_string(m_rows) + " × 3 numbers, more than its " +
                 std::to_string(held) + " bytes hold");
  }

  Status readShape() {
    const std::optional<ScalarType> type = giftiType(m_array.tag.attribute("DataType"));
    if (!type)
      return fault("is of type " + inQuotes(m_array.tag.attribute("DataType")) +
                   ", which is none of a surface");
    m_type = *type;
    const auto size = [&](const char* key) {
      std::int64_t value = -1;
      TextCursor(m_array.tag.attribute(key)).integer(value);
      return value;
    };
    const std::int64_t count = size("Dim0");
    if (count < 1 || size("Dim1") != 3)
      return fault("has no three numbers for each of its rows");
    if (std::uint64_t(count) > std::max(m_source.limits().vertices, m_source.limits().triangles))
      return fault("promises " + std::to_string(count) + " rows, more than the limit",
                   "Reduce the mesh");
    m_rows = std::size_t(count);
    m_columnsFirst = m_array.tag.attribute("ArrayIndexingOrder") == "ColumnMajorOrder";
    return Unit{};
  }

  Status take(std::string bytes) {
    if (bytes.size() / (3 * sizeOf(m_type)) < m_rows)
      return tooFew(bytes.size());
    m_bytes = std::move(bytes);
    return Unit{};
  }

  Status unpack(const std::string& packed) {
    const std::uint64_t wanted = std::uint64_t(m_rows) * 3 * sizeOf(m_type);
    if (wanted >
        std::min(mostUnpacked(packed.size(), Packing::deflated), mostOfSurface(packed.size())))
      return tooFew(packed.size());
    m_bytes.resize(std::size_t(wanted));
    PackedBytes bytes(packed, Packing::deflated);
    if (bytes.read(m_bytes.data(), m_bytes.size()) != m_bytes.size())
      return fault("has packed data that end early or are damaged", "Copy the file again");
    return Unit{};
  }

  template <class Values, class Put>
  Status eachOf(Values values, const Put& put) const {
    const std::size_t all = 3 * m_rows;
    for (std::size_t i = 0; i < all; ++i) {
      const std::size_t row = m_columnsFirst ? i % m_rows : i / 3;
      const auto column = int(m_columnsFirst ? i / m_rows : i % 3);
      if (!put(row, column, values))
        return fault("has no number as its number " + std::to_string(i + 1));
    }
    return Unit{};
  }

  const Source& m_source;
  const GiftiArray& m_array;
  ScalarType m_type = ScalarType::float32;
  std::size_t m_rows = 0;
  bool m_columnsFirst = false;
  bool m_text = false;
  std::string m_bytes;
};

class GiftiParser {
 public:
  explicit GiftiParser(const Source& source) : m_source(source) {}

  Result<RawMeshes> parse() {
    if (const Status status = scan(); !status)
      return status.error();
    const GiftiArray* points = firstOf("NIFTI_INTENT_POINTSET");
    const GiftiArray* triangles = firstOf("NIFTI_INTENT_TRIANGLE");
    if (!points || !triangles)
      return noSurface(points, triangles);
    RawMesh mesh;
    if (const Status status = readPoints(*points, mesh); !status)
      return status.error();
    FaceList faces;
    if (const Status status = readTriangles(*triangles, faces); !status)
      return status.error();
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
    if (Status status = numbers.open(); !status)
      return status;
    mesh.positions.resize(numbers.rows());
    return numbers.each([&](std::size_t row, int column, auto& values) {
      return values.number(numbers.type(), mesh.positions[row][column]);
    });
  }

  Status readTriangles(const GiftiArray& array, FaceList& faces) const {
    GiftiNumbers numbers(m_source, array);
    if (Status status = numbers.open(); !status)
      return status;
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
  const Result<Source> source = Source::read(file, limits);
  if (!source)
    return source.error();
  return GiftiParser(*source).parse();
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
