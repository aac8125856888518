// SPDX-License-Identifier: Apache-2.0
// Reads FreeSurfer's triangle files (surfer.nmr.mgh.harvard.edu, "FreeSurferWiki: surface files"):
// big-endian; three bytes, a comment that ends with an empty line, counts, vertices, triangles, and
// perhaps the volume from which the surface was made. Vertices are given in the axes of that
// volume, from its middle, which is not the scanner's origin.
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/import/readers/cortical_name.h"
#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

constexpr std::string_view triangleMagic = "\xff\xff\xfe";
constexpr const char* saveAgain =
    "Write it again with mris_convert, as a surface of triangles or as GIFTI";

/// Says where the volume of a surface lies: its axes and its middle, in the scanner's RAS.
struct VolumeGeometry {
  glm::dmat3 axes{1.0};
  glm::dvec3 middle{0.0};
};

/// Reads "xras   = -1.0 0.0 0.0", somewhere in the text.
bool threeBehind(std::string_view text, std::string_view key, glm::dvec3& numbers) {
  const std::size_t found = text.find(key);
  if (found == std::string_view::npos)
    return false;
  TextCursor at(text.substr(found + key.size()));
  at.skipBlanks();
  if (at.peek() != '=')
    return false;
  at.moveTo(at.at() + 1);
  for (int i = 0; i < 3; ++i) {
    at.skipBlanks();
    if (!at.number(numbers[i]) || !std::isfinite(numbers[i]))
      return false;
  }
  return true;
}

std::optional<VolumeGeometry> geometryIn(std::string_view footer) {
  VolumeGeometry found;
  const std::size_t valid = footer.find("valid = 1");
  if (valid == std::string_view::npos)
    return std::nullopt;
  const std::string_view text = footer.substr(valid);
  if (!threeBehind(text, "xras", found.axes[0]) || !threeBehind(text, "yras", found.axes[1]) ||
      !threeBehind(text, "zras", found.axes[2]) || !threeBehind(text, "cras", found.middle))
    return std::nullopt;
  // Axes are directions: their span is neither flat nor large.
  const double span = std::abs(glm::determinant(found.axes));
  return span > 0.5 && span < 2.0 ? std::optional(found) : std::nullopt;
}

/// Tells whether the surface has the tag that says its vertices are in the scanner's RAS already.
bool isInScannerRas(std::string_view footer) {
  BinaryValues values(footer.data(), footer.data() + footer.size(), std::endian::big);
  std::int64_t tag = 0;
  std::int64_t real = 0;
  return values.integer(ScalarType::int32, tag) && tag == 2 &&
         values.integer(ScalarType::int32, real) && real == 1;
}

class FreeSurferParser {
 public:
  explicit FreeSurferParser(const Source& source) : m_source(source) {}

  Result<RawMeshes> parse() {
    const std::string_view text = m_source.text();
    if (text.starts_with("\xff\xff\xff") || text.starts_with("\xff\xff\xfd"))
      return m_source.whole("holds quadrangles, as FreeSurfer wrote in the last century",
                            saveAgain);
    const std::size_t comment = text.find("\n\n");
    if (!text.starts_with(triangleMagic) || comment == std::string_view::npos || comment > 4096)
      return m_source.atByte(text.data(), "does not begin like a surface of FreeSurfer", saveAgain);
    BinaryValues values(text.data() + comment + 2, m_source.end(), std::endian::big);
    RawMesh mesh;
    FaceList faces;
    TRY(readVertices(values, mesh));
    TRY(readTriangles(values, faces));
    std::vector<ImportWarning> warnings;
    place(std::string_view(values.at(), std::size_t(m_source.end() - values.at())), mesh, warnings);
    mesh.name = corticalName(m_source.file());
    mesh.frame = Frame::ras;
    mesh.unitReason = "FreeSurfer is in millimetres";
    Result<RawMeshes> read =
        assemble(m_source, std::move(mesh), faces, BadFaces::areErrors, std::move(warnings));
    if (read && m_mirrored)
      for (Triangle& t : read->meshes.front().triangles)
        std::swap(t[1], t[2]);
    return read;
  }

 private:
  Status readVertices(BinaryValues& values, RawMesh& mesh) {
    m_counts = values.at();
    std::int64_t vertices = 0;
    if (!values.integer(ScalarType::int32, vertices) ||
        !values.integer(ScalarType::int32, m_triangles) || vertices < 3 || m_triangles < 1)
      return m_source.atByte(m_counts, "has no counts of vertices and triangles", saveAgain);
    if (std::uint64_t(vertices) * 3 > values.atMost(ScalarType::float32))
      return m_source.atByte(m_counts, "promises " + std::to_string(vertices) +
                                           " vertices, more than the file can hold");
    mesh.positions.resize(std::size_t(vertices));
    for (glm::vec3& p : mesh.positions)
      for (int i = 0; i < 3; ++i)
        values.number(ScalarType::float32, p[i]);
    return Unit{};
  }

  Status readTriangles(BinaryValues& values, FaceList& faces) const {
    if (std::uint64_t(m_triangles) * 3 > values.atMost(ScalarType::int32))
      return m_source.atByte(m_counts, "promises " + std::to_string(m_triangles) +
                                           " triangles, more than the file can hold");
    faces.reserve(std::size_t(m_triangles), 3 * std::size_t(m_triangles));
    for (std::int64_t i = 0; i < m_triangles; ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const char* place = values.at();
        std::int64_t vertex = 0;
        values.integer(ScalarType::int32, vertex);
        faces.add(indexFrom(vertex), place);
      }
      faces.close();
    }
    return Unit{};
  }

  /// Places the mesh. The vertices' axes are those of coronal slices, whatever the volume's: x
  /// against its columns, y along its slices, z against its rows.
  void place(std::string_view footer, RawMesh& mesh, std::vector<ImportWarning>& warnings) {
    if (isInScannerRas(footer)) {
      mesh.frameReason = "scanner RAS, as the surface says";
      return;
    }
    const std::optional<VolumeGeometry> volume = geometryIn(footer);
    mesh.frameReason =
        volume ? "FreeSurfer is RAS; moved to where its volume lies" : "FreeSurfer is RAS";
    if (!volume) {
      warnings.push_back(m_source.warning(
          "does not say where the volume lies that it was made of: it may be some millimetres away "
          "from volumes and other surfaces of the same head"));
      return;
    }
    const glm::dmat3 turn(-volume->axes[0], volume->axes[2], -volume->axes[1]);
    m_mirrored = glm::determinant(turn) < 0.0;
    for (glm::vec3& p : mesh.positions)
      p = glm::vec3(turn * glm::dvec3(p) + volume->middle);
  }

  const Source& m_source;
  const char* m_counts = nullptr;
  std::int64_t m_triangles = 0;
  bool m_mirrored = false;
};

}  // namespace

Result<RawMeshes> readFreeSurferSurface(const std::filesystem::path& file,
                                        const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return FreeSurferParser(source).parse();
}

bool isFreeSurferAnatomy(const std::filesystem::path& file) {
  std::array<char, 3> bytes{};
  std::FILE* handle = isCalledAnatomical(file) ? std::fopen(file.string().c_str(), "rb") : nullptr;
  if (!handle)
    return false;
  const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), handle);
  std::fclose(handle);
  return std::string_view(bytes.data(), size) == triangleMagic;
}

}  // namespace sline::model
