// SPDX-License-Identifier: Apache-2.0
// Reads glTF 2.0 and GLB: every primitive of triangles in the scene becomes a surface in scene
// coordinates (metres, +y up). Skins, morph targets and textures are not read.
#include "model/import/readers/gltf/gltf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <map>
#include <string>

#include "model/base/letters.h"
#include "model/import/readers/gltf/gltf_document.h"
#include "model/import/source/colour_of_light.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {
constexpr const char* dracoExtension = "KHR_draco_mesh_compression";
constexpr const char* meshoptExtension = "EXT_meshopt_compression";
enum Mode : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

class GltfReader {
 public:
  GltfReader(const Source& source, GltfDocument& document)
      : m_source(source), m_document(document) {}

  Result<RawMeshes> read() {
    const std::vector<GltfInstance> instances = TRY(meshInstances(m_document));
    for (const GltfInstance& instance : instances) {
      TRY(readMesh(instance));
    }
    if (m_result.meshes.empty())
      return m_source.whole(m_result.warnings.empty()
                                ? "holds no meshes in its scene"
                                : "holds no triangles: " + m_result.warnings.front().reason,
                            "Export the mesh again, uncompressed and as triangles");
    return std::move(m_result);
  }

 private:
  Status readMesh(const GltfInstance& instance) {
    const Json* mesh = element(m_document.root, "meshes", instance.mesh);
    const Json* primitives = mesh ? member(*mesh, "primitives") : nullptr;
    const std::string place = placeOf("meshes", instance.mesh);
    if (!primitives || !primitives->is_array())
      return m_source.at(place, "has no primitives");
    const Json* node = element(m_document.root, "nodes", instance.node);
    if (node && member(*node, "skin"))
      warn(place, "its skin is left out; it stands as it was bound");
    for (std::size_t i = 0; i < primitives->size(); ++i) {
      const std::string where = place + "." + placeOf("primitives", i);
      TRY(readPrimitive((*primitives)[i], instance, where));
    }
    return Unit{};
  }

  void warn(const std::string& where, const std::string& reason) {
    m_result.warnings.push_back(m_source.warning(where + " " + reason));
  }

  /// Returns true where the primitive is one that cannot be read; the rest of the file may still be
  /// good.
  bool isLeftOut(const Json& primitive, std::uint64_t mode, const std::string& where) {
    if (extension(primitive, dracoExtension) && !m_document.decoders.mesh) {
      warn(where, "is compressed by KHR_draco_mesh_compression, which is not supported");
      return true;
    }
    if (mode < triangles) {
      warn(where, "is made of points or lines and left out");
      return true;
    }
    return false;
  }

  Status readPrimitive(const Json& primitive, const GltfInstance& instance,
                       const std::string& where) {
    const std::uint64_t mode = wholeMember(primitive, "mode").value_or(triangles);
    if (mode > fan)
      return m_source.at(where, "has mode " + std::to_string(mode) + ", which does not exist");
    if (isLeftOut(primitive, mode, where))
      return Unit{};
    if (const Json* packed = extension(primitive, dracoExtension))
      return readPacked(primitive, *packed, instance, where);
    const Json* attributes = member(primitive, "attributes");
    const auto accessor = attributes ? wholeMember(*attributes, "POSITION") : std::nullopt;
    if (!accessor)
      return m_source.at(where, "has no POSITION");
    if (!m_positions.contains(*accessor)) {
      std::vector<glm::vec3> read = TRY(readPositions(m_document, *accessor));
      m_positions.emplace(*accessor, std::move(read));
    }
    const std::vector<glm::vec3>& positions = m_positions.at(*accessor);
    std::vector<std::uint32_t> indices = TRY(cornersOf(primitive, positions.size(), where));
    RawMesh mesh = opened(primitive, instance);
    mesh.triangles = cut(indices, Mode(mode));
    keepUsed(positions, m_scratch[*accessor], mesh);
    place(mesh, instance.toScene);
    return finish(m_source, std::move(mesh), m_result);
  }

  /// Reads a primitive that is unpacked as a whole, whatever its mode: it has become triangles.
  Status readPacked(const Json& primitive, const Json& packed, const GltfInstance& instance,
                    const std::string& where) {
    if (!m_unpacked.contains(&packed)) {
      GltfUnpackedMesh read = TRY(unpackMesh(m_document, packed, where));
      m_unpacked.emplace(&packed, std::move(read));
    }
    const GltfUnpackedMesh& unpacked = m_unpacked.at(&packed);
    const std::vector<glm::vec3>& positions = unpacked.positions;
    TRY(grant(unpacked.corners.size(), where));
    RawMesh mesh = opened(primitive, instance);
    mesh.triangles = cut(unpacked.corners, Mode::triangles);
    std::vector<std::uint32_t> scratch;
    keepUsed(positions, scratch, mesh);
    place(mesh, instance.toScene);
    return finish(m_source, std::move(mesh), m_result);
  }

  Status grant(std::size_t corners, const std::string& where) {
    const std::uint64_t bytes = 24 * std::uint64_t(corners);
    if (bytes > m_document.budget)
      return m_source.at(where, "the scene repeats its meshes far beyond the size of the file",
                         "Reduce the number of instances");
    m_document.budget -= bytes;
    return Unit{};
  }

  /// Returns the corners in drawing order: the indices, or all vertices in turn. Memory for the
  /// triangles they make is taken from the budget.
  Result<std::vector<std::uint32_t>> cornersOf(const Json& primitive, std::size_t vertices,
                                               const std::string& where) {
    std::vector<std::uint32_t> corners;
    if (const Json* accessor = member(primitive, "indices")) {
      corners = TRY(readIndices(m_document, accessor->is_number_unsigned()
                                                ? accessor->get<std::uint64_t>()
                                                : UINT64_MAX));
    } else {
      corners.resize(vertices);
      for (std::size_t i = 0; i < vertices; ++i)
        corners[i] = std::uint32_t(i);
    }
    TRY(grant(corners.size(), where));
    for (const std::uint32_t v : corners)
      if (v >= vertices)
        return m_source.at(where, "index " + std::to_string(v) + " is beyond its " +
                                      std::to_string(vertices) + " vertices");
    return corners;
  }

  /// Makes triangles of corners by §3.7.2.1.
  static std::vector<Triangle> cut(const std::vector<std::uint32_t>& c, Mode mode) {
    std::vector<Triangle> result;
    const std::size_t step = mode == Mode::triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < c.size(); i += step) {
      const bool odd = mode == Mode::strip && i % 2 == 1;
      const Triangle t = mode == Mode::fan
                             ? Triangle{c[0], c[i + 1], c[i + 2]}
                             : Triangle{c[odd ? i + 1 : i], c[odd ? i : i + 1], c[i + 2]};
      const bool repeated = t[0] == t[1] || t[1] == t[2] || t[0] == t[2];
      if (mode != Mode::strip || !repeated)
        result.push_back(t);
    }
    return result;
  }

  static void place(RawMesh& mesh, const glm::dmat4& toScene) {
    for (glm::vec3& p : mesh.positions) {
      const glm::dvec4 moved = toScene * glm::dvec4(p, 1.0);
      p = {narrowed(moved.x), narrowed(moved.y), narrowed(moved.z)};
    }
    // A mirroring transform turns surfaces inside out (§3.5.2), so the triangles are turned as
    // well.
    if (glm::determinant(glm::dmat3(toScene)) < 0.0)
      for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
  }

  RawMesh opened(const Json& primitive, const GltfInstance& instance) const {
    RawMesh mesh;
    mesh.name = instance.name;
    mesh.groups = instance.groups;
    mesh.millimetresPerUnit = 1000.0f;
    mesh.unitReason = "glTF: metres";
    mesh.yUp = true;
    mesh.frame = Frame::lps;
    mesh.frameReason = "glTF: +y up, +x the patient's left";
    const Json* material = element(m_document.root, "materials",
                                   wholeMember(primitive, "material").value_or(UINT64_MAX));
    const Json* surface = material ? member(*material, "pbrMetallicRoughness") : nullptr;
    if (!surface)
      return mesh;
    const std::vector<double> factor = numbersMember(*surface, "baseColorFactor", 4);
    if (factor.empty())
      return mesh;
    mesh.colour = colourOfLight({factor[0], factor[1], factor[2]});
    if (textMember(*material, "alphaMode") == "BLEND")
      mesh.opacity = Opacity::clamped(float(factor[3]));
    return mesh;
  }

  const Source& m_source;
  GltfDocument& m_document;
  RawMeshes m_result;
  /// Holds positions that are decoded once, however many primitives share them.
  std::map<std::uint64_t, std::vector<glm::vec3>> m_positions;
  std::map<std::uint64_t, std::vector<std::uint32_t>> m_scratch;
  std::map<const Json*, GltfUnpackedMesh> m_unpacked;
};
}  // namespace

Result<RawMeshes> readGltf(const std::filesystem::path& file, const ReadLimits& limits) {
  return readGltfWith({}, file, limits);
}

Result<RawMeshes> readGltfWith(const GltfDecoders& decoders, const std::filesystem::path& file,
                               const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  try {
    GltfDocument document = TRY(openGltf(source));
    document.decoders = decoders;
    loadBuffers(document);
    return GltfReader(source, document).read();
  } catch (const Json::exception& e) {
    return source.whole(std::string("its JSON is not as glTF wants it: ") + e.what());
  }
}

namespace {
bool speaksOfCompression(std::string_view json) {
  return json.find(dracoExtension) != std::string_view::npos ||
         json.find(meshoptExtension) != std::string_view::npos;
}
}  // namespace

bool isCompressedGltf(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code || !std::filesystem::is_regular_file(file, code) || size > ReadLimits{}.fileBytes)
    return false;
  if (equalsIgnoringCase(file.extension().string(), ".gz")) {
    const Result<Source> packed = Source::read(file, {});
    return packed && speaksOfCompression(packed->text());
  }
  std::ifstream in(file, std::ios::binary);
  // A GLB begins with its JSON; the rest may be long.
  std::array<char, 20> head{};
  in.read(head.data(), head.size());
  const bool glb = in && std::string_view(head.data(), 4) == "glTF";
  const std::uint64_t length =
      glb ? loadAs<std::uint32_t>(head.data() + 12, std::endian::native != std::endian::little)
          : size;
  std::string json(std::size_t(std::min<std::uint64_t>(length, size)), '\0');
  in.clear();
  in.seekg(glb ? std::streamoff(head.size()) : 0);
  in.read(json.data(), std::streamsize(json.size()));
  return speaksOfCompression(json);
}

}  // namespace sline::model
