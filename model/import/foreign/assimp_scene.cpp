// SPDX-License-Identifier: Apache-2.0
#include "model/import/foreign/assimp_scene.h"

#include <assimp/material.h>
#include <assimp/mesh.h>

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <set>
#include <span>

#include "model/import/source/colour_of_light.h"
#include "model/import/source/polygon.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/values.h"
#include "model/import/source/welder.h"

namespace sline::model {

namespace {

constexpr std::size_t deepestNode = 256;
/// The bytes that instances may make of a file beyond its own meshes: small files may be multiplied
/// freely.
constexpr std::uint64_t alwaysAllowed = std::uint64_t(64) << 20;
constexpr std::uint64_t bytesPerByte = 64;

/// Describes a node that is waiting to be visited and what it inherits.
struct NodeVisit {
  const aiNode* node = nullptr;
  std::size_t depth = 0;
  std::vector<std::string> groups;
  glm::dmat4 above{1.0};
};

std::string textOf(const aiString& text) {
  return {text.data, std::min<std::size_t>(text.length, sizeof(text.data) - 1)};
}

/// Returns the node's name; assimp makes several nodes of one that has pivots, called
/// NAME_$AssimpFbx$_Translation and so on.
std::string nodeName(const aiNode& node) {
  std::string name = textOf(node.mName);
  if (const std::size_t at = name.find("_$AssimpFbx$"); at != std::string::npos)
    name.erase(at);
  return name;
}

class AssimpSceneReader {
 public:
  AssimpSceneReader(const aiScene& scene, const AssimpConvention& convention, const Source& source)
      : m_scene(scene),
        m_convention(convention),
        m_source(source),
        m_budget(alwaysAllowed + bytesPerByte * source.size()) {}

  Result<RawMeshes> read() {
    std::vector<NodeVisit> waiting{{m_scene.mRootNode, 0, {}, m_convention.below}};
    while (!waiting.empty()) {
      const NodeVisit visit = std::move(waiting.back());
      waiting.pop_back();
      TRY(visitNode(visit));
      TRY(pushChildren(visit, waiting));
    }
    if (m_result.meshes.empty())
      return m_source.whole(m_result.warnings.empty()
                                ? "holds no meshes"
                                : "holds no triangles: " + m_result.warnings.front().reason,
                            "Export the mesh again, as triangles");
    return std::move(m_result);
  }

 private:
  Status pushChildren(const NodeVisit& visit, std::vector<NodeVisit>& waiting) {
    if (visit.depth > deepestNode)
      return m_source.at(inQuotes(nodeName(*visit.node)), "lies more than 256 levels deep");
    const std::string name = nodeName(*visit.node);
    std::vector<std::string> groups = visit.groups;
    // The root stands for the file; the parts of a node with pivots stand in each other.
    if (visit.depth > 0 && !name.empty() && (groups.empty() || groups.back() != name))
      groups.push_back(name);
    std::uint64_t bytes = 64;
    for (const std::string& group : groups)
      bytes += sizeof(std::string) + group.size();
    TRY(spend(bytes * visit.node->mNumChildren, name));
    const std::span children(visit.node->mChildren, visit.node->mNumChildren);
    for (std::size_t i = children.size(); i > 0; --i)
      if (children[i - 1])
        waiting.push_back({children[i - 1], visit.depth + 1, groups,
                           visit.above * matrixOf(children[i - 1]->mTransformation)});
    return Unit{};
  }

  Status visitNode(const NodeVisit& visit) {
    const std::string name = nodeName(*visit.node);
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      const unsigned index = visit.node->mMeshes[i];
      if (index >= m_scene.mNumMeshes)
        return m_source.at(inQuotes(name), "refers to a mesh that does not exist");
      const aiMesh& mesh = *m_scene.mMeshes[index];
      if (!isFinite(visit.above))
        return m_source.at(inQuotes(name), "its transform is not finite");
      const std::uint64_t bytes = 24 * std::uint64_t(mesh.mNumVertices) +
                                  32 * std::uint64_t(mesh.mNumFaces) + name.size() + 256;
      TRY(spend(bytes, name));
      TRY(add(mesh, visit, name));
    }
    return Unit{};
  }

  Status spend(std::uint64_t bytes, const std::string& name) {
    if (bytes > m_budget)
      return m_source.at(inQuotes(name), "the scene repeats its meshes far beyond the file's size",
                         "Reduce the number of instances");
    m_budget -= bytes;
    return Unit{};
  }

  Status add(const aiMesh& from, const NodeVisit& visit, const std::string& name) {
    RawMesh mesh;
    mesh.name = visit.depth == 0 || name.empty() ? textOf(from.mName) : name;
    mesh.groups = visit.groups;
    if (!mesh.groups.empty() && mesh.groups.back() == mesh.name)
      mesh.groups.pop_back();
    mesh.millimetresPerUnit = m_convention.millimetresPerUnit;
    mesh.unitReason = m_convention.unitReason;
    mesh.yUp = m_convention.yUp;
    paint(mesh, from);
    TRY(cutFacesOf(from, visit.above, mesh));
    // A mirroring transform turns surfaces inside out, so the triangles are turned as well.
    if (glm::determinant(glm::dmat3(visit.above)) < 0.0)
      for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    if (from.mNumBones > 0 && m_skins.insert(mesh.name).second)
      m_result.warnings.push_back(m_source.warning("the skin of " + inQuotes(mesh.name) +
                                                   " is left out; it stands as it was bound"));
    return finish(m_source, std::move(mesh), m_result);
  }

  Status cutFacesOf(const aiMesh& from, const glm::dmat4& toScene, RawMesh& mesh) {
    Welder welder(3 * std::size_t(from.mNumFaces));
    std::vector<std::uint32_t> vertexOf(from.mNumVertices);
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& p = from.mVertices[i];
      const glm::dvec4 moved = toScene * glm::dvec4(p.x, p.y, p.z, 1.0);
      vertexOf[i] = welder.vertex({narrowed(moved.x), narrowed(moved.y), narrowed(moved.z)});
    }
    mesh.positions = welder.take();
    std::size_t notFaces = 0;
    std::vector<std::uint32_t> loop;
    for (const aiFace& face : std::span(from.mFaces, from.mNumFaces)) {
      loop.clear();
      for (const unsigned corner : std::span(face.mIndices, face.mNumIndices)) {
        if (corner >= from.mNumVertices)
          return m_source.at(inQuotes(mesh.name), "its faces refer to vertices that do not exist");
        loop.push_back(vertexOf[corner]);
      }
      if (loop.size() < 3)
        ++notFaces;
      else
        cutPolygon(loop, mesh.positions, mesh.triangles);
    }
    if (notFaces > 0)
      m_result.warnings.push_back(m_source.warning(
          std::to_string(notFaces) + " lines or points are left out of " + inQuotes(mesh.name)));
    return Unit{};
  }

  /// Takes the colour of a material without a picture; assimp makes one for meshes that have none.
  void paint(RawMesh& mesh, const aiMesh& from) const {
    if (from.mMaterialIndex >= m_scene.mNumMaterials)
      return;
    const aiMaterial& material = *m_scene.mMaterials[from.mMaterialIndex];
    aiString name;
    aiColor4D colour;
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
        textOf(name) == AI_DEFAULT_MATERIAL_NAME)
      return;
    const bool pictured = material.GetTextureCount(aiTextureType_DIFFUSE) > 0 ||
                          material.GetTextureCount(aiTextureType_BASE_COLOR) > 0;
    if (!pictured && material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
      const auto channel = [](float value) {
        return std::uint8_t(std::lround(255.0f * (value > 0.0f ? std::min(value, 1.0f) : 0.0f)));
      };
      mesh.colour = m_convention.light
                        ? colourOfLight({colour.r, colour.g, colour.b})
                        : Colour{channel(colour.r), channel(colour.g), channel(colour.b)};
    }
    // Programs disagree on which end of the scale is opaque: no program exports what cannot be
    // seen, so a fully transparent value is ignored.
    float opacity = 1.0f;
    if (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity > 0.0f &&
        opacity < 1.0f)
      mesh.opacity = Opacity::clamped(opacity);
  }

  const aiScene& m_scene;
  const AssimpConvention& m_convention;
  const Source& m_source;
  std::uint64_t m_budget;
  RawMeshes m_result;
  std::set<std::string> m_skins;
};

}  // namespace

Result<RawMeshes> meshesOf(const aiScene& scene, const AssimpConvention& convention,
                           const Source& source) {
  return AssimpSceneReader(scene, convention, source).read();
}

}  // namespace sline::model
