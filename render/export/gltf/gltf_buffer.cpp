// SPDX-License-Identifier: Apache-2.0
#include "render/export/gltf/gltf_buffer.h"

#include <bit>
#include <glm/geometric.hpp>

#include "model/geometry/normals.h"

namespace sline::render {

namespace {

// glTF 2.0 §5.1.2, §5.11.5.
enum ComponentType { unsignedShort = 5123, unsignedInt = 5125, floating = 5126 };
enum Target { arrayBuffer = 34962, elementBuffer = 34963 };

template <class Bits>
void append(std::string& bytes, Bits bits) {
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    bytes.push_back(char(bits >> (8 * i)));
}

void append(std::string& bytes, const glm::vec3& p) {
  for (int axis = 0; axis < 3; ++axis)
    append(bytes, std::bit_cast<std::uint32_t>(p[axis]));
}

/// Returns the unit vectors that glTF requires at each vertex, even at one without faces or with
/// faces without area.
std::vector<glm::vec3> unitNormals(const model::Mesh& mesh) {
  std::vector<glm::vec3> normals = model::vertexNormals(mesh);
  for (glm::vec3& n : normals)
    if (!(std::abs(glm::length(n) - 1.0f) < 1e-4f))
      n = {0.0f, 0.0f, 1.0f};
  return normals;
}

}  // namespace

double GltfBuffer::bytesOf(const model::Mesh& mesh) {
  // A place and a normal for each vertex, three indices for each triangle.
  const double index = mesh.vertexCount() <= 65535 ? 2.0 : 4.0;
  return 2.0 * sizeof(glm::vec3) * double(mesh.vertexCount()) +
         3.0 * index * double(mesh.triangleCount());
}

const GltfSurface& GltfBuffer::surfaceOf(const model::MeshPtr& mesh) {
  const auto known = m_surfaces.find(mesh);
  if (known != m_surfaces.end())
    return known->second;
  GltfSurface surface;
  surface.positions = points(mesh->positions(), true);
  surface.normals = points(unitNormals(*mesh), false);
  surface.indices = triangles(*mesh);
  return m_surfaces.emplace(mesh, surface).first->second;
}

int GltfBuffer::points(std::span<const glm::vec3> values, bool withBounds) {
  const int view = open(arrayBuffer);
  model::Box box;
  for (const glm::vec3& p : values) {
    append(m_bytes, p);
    box.add(p);
  }
  close();
  Json described{{"bufferView", view},
                 {"componentType", floating},
                 {"count", values.size()},
                 {"type", "VEC3"}};
  if (withBounds) {
    // Exact to the last bit: readers compare them with the values.
    described["min"] = {double(box.low.x), double(box.low.y), double(box.low.z)};
    described["max"] = {double(box.high.x), double(box.high.y), double(box.high.z)};
  }
  return accessor(std::move(described));
}

int GltfBuffer::numbers(std::span<const float> values) {
  const int view = open(arrayBuffer);
  for (const float value : values)
    append(m_bytes, std::bit_cast<std::uint32_t>(value));
  close();
  return accessor({{"bufferView", view},
                   {"componentType", floating},
                   {"count", values.size()},
                   {"type", "SCALAR"}});
}

int GltfBuffer::triangles(const model::Mesh& mesh) {
  // The greatest index of a type means a new start and no vertex (§3.7.2.1).
  const bool isShort = mesh.vertexCount() <= 65535;
  const int view = open(elementBuffer);
  for (const model::Triangle& triangle : mesh.triangles())
    for (const std::uint32_t corner : triangle) {
      if (isShort)
        append(m_bytes, std::uint16_t(corner));
      else
        append(m_bytes, corner);
    }
  close();
  return accessor({{"bufferView", view},
                   {"componentType", isShort ? unsignedShort : unsignedInt},
                   {"count", 3 * mesh.triangleCount()},
                   {"type", "SCALAR"}});
}

int GltfBuffer::accessor(Json described) {
  m_accessors.push_back(std::move(described));
  return int(m_accessors.size()) - 1;
}

int GltfBuffer::open(int target) {
  m_views.push_back(
      {{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", 0}, {"target", target}});
  return int(m_views.size()) - 1;
}

void GltfBuffer::close() {
  Json& view = m_views.back();
  view["byteLength"] = m_bytes.size() - view["byteOffset"].get<std::size_t>();
  m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');
}

}  // namespace sline::render
