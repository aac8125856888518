// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/clusters.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
struct Source {
  const Mesh& mesh;
  std::span<const glm::vec3> normals;
  const Curvature& curvature;
};

glm::vec3 faceNormal(const Mesh& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles()[face];
  const auto p = mesh.positions();
  const glm::vec3 area = glm::cross(p[b] - p[a], p[c] - p[a]);
  const float length = glm::length(area);
  return length > 0.0f ? area / length : glm::vec3(0.0f);
}

void bound(Cluster& cluster, const Source& source, std::span<const std::uint32_t> vertices,
           std::span<const std::uint32_t> faces) {
  Box box;
  glm::vec3 sum(0.0f);
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  for (const std::uint32_t v : vertices) {
    box.add(source.mesh.positions()[v]);
    sum += source.normals[v];
    const glm::vec2 k = source.curvature.k[v];
    lowest = std::min({lowest, k.x, k.y});
    highest = std::max({highest, k.x, k.y});
  }
  cluster.lowestCurvature = lowest;
  cluster.highestCurvature = highest;
  cluster.bounds.centre = box.centre();
  float squared = 0.0f;
  for (const std::uint32_t v : vertices) {
    const glm::vec3 d = source.mesh.positions()[v] - cluster.bounds.centre;
    squared = std::max(squared, glm::dot(d, d));
  }
  cluster.bounds.radius = std::sqrt(squared) * 1.0001f;
  const float length = glm::length(sum);
  if (!(length > 0.0f))
    return;
  cluster.coneAxis = sum / length;
  float cosine = 1.0f;
  const auto include = [&](const glm::vec3& n) {
    if (n != glm::vec3(0.0f))
      cosine = std::min(cosine, glm::dot(cluster.coneAxis, n));
  };
  for (const std::uint32_t v : vertices)
    include(source.normals[v]);
  for (const std::uint32_t f : faces)
    include(faceNormal(source.mesh, f));
  cluster.coneCosine = cosine;
}

/// Numbers the vertices of one cluster after another by remembering which cluster used a vertex
/// last, and its number there.
class LocalNumbers {
 public:
  explicit LocalNumbers(std::size_t vertexCount) : m_seen(vertexCount, {0, 0}) {}
  void startCluster() { ++m_cluster; }
  /// Returns the vertex's number in this cluster; a new vertex is appended to `vertices`.
  std::uint32_t number(std::uint32_t vertex, std::vector<std::uint32_t>& vertices,
                       std::size_t first) {
    Seen& seen = m_seen[vertex];
    if (seen.cluster != m_cluster) {
      seen = {m_cluster, std::uint32_t(vertices.size() - first)};
      vertices.push_back(vertex);
    }
    return seen.number;
  }

 private:
  struct Seen {
    std::uint32_t cluster;
    std::uint32_t number;
  };
  std::vector<Seen> m_seen;
  std::uint32_t m_cluster = 0;
};

/// Appends clusters of the faces in order; a cluster that would use too many vertices ends early.
void cut(Clusters& clusters, const Mesh& mesh) {
  LocalNumbers numbers(mesh.vertexCount());
  const std::size_t count = clusters.triangles.size();
  clusters.localTriangles.reserve(count);
  clusters.vertices.reserve(mesh.vertexCount() + mesh.vertexCount() / 2);
  std::size_t slot = 0;
  while (slot < count) {
    Cluster cluster{.firstTriangle = std::uint32_t(slot),
                    .firstVertex = std::uint32_t(clusters.vertices.size())};
    numbers.startCluster();
    const std::size_t end = std::min<std::size_t>(count, slot + Clusters::maximumTriangles);
    while (slot < end &&
           clusters.vertices.size() - cluster.firstVertex + 3 <= Clusters::maximumVertices) {
      std::array<std::uint8_t, 3> local{};
      for (std::size_t c = 0; c < 3; ++c)
        local[c] = std::uint8_t(numbers.number(mesh.triangles()[clusters.triangles[slot]][c],
                                               clusters.vertices, cluster.firstVertex));
      clusters.localTriangles.push_back(local);
      ++slot;
    }
    cluster.triangleCount = std::uint32_t(slot) - cluster.firstTriangle;
    cluster.vertexCount = std::uint32_t(clusters.vertices.size()) - cluster.firstVertex;
    clusters.items.push_back(cluster);
  }
}

/// Copies the values that views read into cluster order.
ClusterVertices gathered(const Source& source, const std::vector<std::uint32_t>& vertices) {
  ClusterVertices fields;
  for (auto* group : {&fields.position, &fields.normal})
    for (std::vector<float>& field : *group)
      field.resize(vertices.size());
  for (std::vector<float>& field : fields.s)
    field.resize(vertices.size());
  parallelFor(vertices.size(), 8192, [&](std::size_t i) {
    const std::uint32_t v = vertices[i];
    const glm::vec3 n = source.normals[v];
    const glm::vec3 e1 = source.curvature.e1[v];
    const glm::vec3 e2 = glm::cross(n, e1);
    const glm::vec3 a = source.curvature.k[v].x * e1;
    const glm::vec3 b = source.curvature.k[v].y * e2;
    for (glm::length_t c = 0; c < 3; ++c) {
      fields.position[std::size_t(c)][i] = source.mesh.positions()[v][c];
      fields.normal[std::size_t(c)][i] = n[c];
    }
    fields.s[0][i] = a.x * e1.x + b.x * e2.x;
    fields.s[1][i] = a.x * e1.y + b.x * e2.y;
    fields.s[2][i] = a.x * e1.z + b.x * e2.z;
    fields.s[3][i] = a.y * e1.y + b.y * e2.y;
    fields.s[4][i] = a.y * e1.z + b.y * e2.z;
    fields.s[5][i] = a.z * e1.z + b.z * e2.z;
  });
  return fields;
}
}  // namespace

Clusters buildClusters(const Mesh& mesh, std::vector<std::uint32_t> order,
                       std::span<const glm::vec3> normals, const Curvature& curvature) {
  const Source source{mesh, normals, curvature};
  Clusters clusters;
  clusters.triangles = std::move(order);
  cut(clusters, mesh);
  clusters.vertices.shrink_to_fit();
  parallelFor(clusters.items.size(), 32, [&](std::size_t i) {
    Cluster& c = clusters.items[i];
    bound(c, source, {clusters.vertices.data() + c.firstVertex, c.vertexCount},
          {clusters.triangles.data() + c.firstTriangle, c.triangleCount});
  });
  clusters.fields = gathered(source, clusters.vertices);
  return clusters;
}

Facing facing(const Cluster& cluster, const EyePoint& eye) {
  const glm::vec3 toEye = eye.atInfinity ? eye.value : eye.value - cluster.bounds.centre;
  const float distance = glm::length(toEye);
  // α is the opening of the normal cone; β is how much the line of sight turns within the bounding
  // sphere.
  const float sinBeta = eye.atInfinity ? 0.0f : cluster.bounds.radius / std::max(distance, 1e-30f);
  const float cosAlpha = cluster.coneCosine;
  if (!(sinBeta < 1.0f) || !(cosAlpha > 0.0f))
    return Facing::mixed;
  const float cosBeta = std::sqrt(1.0f - sinBeta * sinBeta);
  const float sinAlpha = std::sqrt(std::max(0.0f, 1.0f - cosAlpha * cosAlpha));
  if (cosAlpha * cosBeta - sinAlpha * sinBeta <= 0.0f)
    return Facing::mixed;
  const float sinSum = sinAlpha * cosBeta + cosAlpha * sinBeta + 1e-5f;
  const float cosine = glm::dot(cluster.coneAxis, toEye) / distance;
  if (cosine > sinSum)
    return Facing::front;
  return cosine < -sinSum ? Facing::back : Facing::mixed;
}

}  // namespace sline::model
