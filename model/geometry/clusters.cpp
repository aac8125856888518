// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/clusters.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
using Matrix = std::array<float, 6>;

struct Source {
  const Mesh& mesh;
  std::span<const SurfaceVertex> vertices;
};

glm::vec3 faceNormal(const Mesh& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles()[face];
  const auto p = mesh.positions();
  const glm::vec3 area = glm::cross(p[b] - p[a], p[c] - p[a]);
  const float length = glm::length(area);
  return length > 0.0f ? area / length : glm::vec3(0.0f);
}

/// Returns whether κr may vanish somewhere in the triangle, from some eye.
bool mayBend(std::span<const SurfaceVertex> vertices, const Triangle& t) {
  const glm::vec2& a = vertices[t[0]].k;
  const glm::vec2& b = vertices[t[1]].k;
  const glm::vec2& c = vertices[t[2]].k;
  return !(std::min({a.x, a.y, b.x, b.y, c.x, c.y}) > 0.0f) &&
         !(std::max({a.x, a.y, b.x, b.y, c.x, c.y}) < 0.0f);
}

void boundShape(Cluster& cluster, const Source& source, std::span<const std::uint32_t> vertices,
                std::span<const std::uint32_t> faces) {
  Box box;
  glm::vec3 sum(0.0f);
  for (const std::uint32_t v : vertices) {
    box.add(source.vertices[v].position);
    sum += source.vertices[v].normal;
  }
  cluster.bounds.centre = box.centre();
  float squared = 0.0f;
  for (const std::uint32_t v : vertices) {
    const glm::vec3 d = source.vertices[v].position - cluster.bounds.centre;
    squared = std::max(squared, glm::dot(d, d));
  }
  cluster.bounds.radius = std::sqrt(squared) * 1.0001f;
  const float length = glm::length(sum);
  if (!(length > 0.0f))
    return;
  cluster.cone.axis = sum / length;
  float cosine = 1.0f;
  const auto include = [&](const glm::vec3& n) {
    if (n != glm::vec3(0.0f))
      cosine = std::min(cosine, glm::dot(cluster.cone.axis, n));
  };
  for (const std::uint32_t v : vertices)
    include(source.vertices[v].normal);
  for (const std::uint32_t f : faces)
    include(faceNormal(source.mesh, f));
  cluster.cone.cosine = cosine;
}

float norm(const Matrix& m) {
  return std::sqrt(m[0] * m[0] + m[3] * m[3] + m[5] * m[5] +
                   2.0f * (m[1] * m[1] + m[2] * m[2] + m[4] * m[4]));
}

/// Returns what stands for the nearest whole number of steps.
std::uint8_t sampleOf(float difference, float perStep) {
  const float steps =
      std::clamp(std::round(difference * perStep), -Clusters::mostSteps, Clusters::mostSteps);
  return std::uint8_t(Clusters::mostSteps + steps);
}

/// Appends the samples of positions and normals, which are bounded.
void samplePlaces(Cluster& cluster, const Source& source, std::span<const std::uint32_t> vertices,
                  std::vector<std::uint8_t>& samples) {
  const Sphere& places = cluster.bounds;
  float reach = 0.0f;
  for (const std::uint32_t v : vertices) {
    const glm::vec3 turned = glm::abs(source.vertices[v].normal - cluster.cone.axis);
    reach = std::max({reach, turned.x, turned.y, turned.z});
  }
  cluster.normalStep = reach / Clusters::mostSteps;
  const float perNormal = reach > 0.0f ? Clusters::mostSteps / reach : 0.0f;
  const float perPlace = places.radius > 0.0f ? Clusters::mostSteps / places.radius : 0.0f;
  const std::size_t count = vertices.size();
  const std::size_t first = samples.size();
  samples.resize(first + Clusters::placeRows * count);
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceVertex& v = source.vertices[vertices[i]];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto axis = glm::length_t(c);
      samples[first + c * count + i] = sampleOf(v.position[axis] - places.centre[axis], perPlace);
      samples[first + (3 + c) * count + i] =
          sampleOf(v.normal[axis] - cluster.cone.axis[axis], perNormal);
    }
  }
}

/// Bounds the shape operators of these vertices, and appends their samples.
TensorBounds boundTensors(const Source& source, std::span<const std::uint32_t> vertices,
                          std::vector<std::uint8_t>& samples) {
  TensorBounds bounds;
  if (vertices.empty())
    return bounds;
  std::array<Matrix, Clusters::maximumVertices> s;
  Matrix low;
  low.fill(std::numeric_limits<float>::infinity());
  Matrix high;
  high.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const SurfaceVertex& v = source.vertices[vertices[i]];
    bounds.largest = std::max({bounds.largest, std::abs(v.k.x), std::abs(v.k.y)});
    s[i] = shapeOperator(v);
    for (std::size_t c = 0; c < 6; ++c) {
      low[c] = std::min(low[c], s[i][c]);
      high[c] = std::max(high[c], s[i][c]);
    }
  }
  float reach = 0.0f;
  for (std::size_t c = 0; c < 6; ++c) {
    bounds.middle[c] = 0.5f * (low[c] + high[c]);
    reach = std::max(reach, 0.5f * (high[c] - low[c]));
  }
  bounds.step = reach / Clusters::mostSteps;
  const float perStep = reach > 0.0f ? Clusters::mostSteps / reach : 0.0f;
  const std::size_t count = vertices.size();
  const std::size_t first = samples.size();
  samples.resize(first + Clusters::bendingRows * count);
  for (std::size_t i = 0; i < count; ++i) {
    Matrix difference;
    for (std::size_t c = 0; c < 6; ++c) {
      difference[c] = s[i][c] - bounds.middle[c];
      samples[first + c * count + i] = sampleOf(difference[c], perStep);
    }
    bounds.spread = std::max(bounds.spread, norm(difference));
  }
  return bounds;
}

/// Returns the smallest cone around the axis that holds these.
NormalCone coneOf(const glm::vec3& axis, std::span<const Cluster> clusters) {
  NormalCone all{.axis = axis, .cosine = 1.0f};
  for (const Cluster& cluster : clusters) {
    const float apart = std::clamp(glm::dot(axis, cluster.cone.axis), -1.0f, 1.0f);
    const float own = cluster.cone.cosine;
    // The sum of both angles must stay below half a turn.
    if (!(own > -apart))
      return {};
    const float sines = std::sqrt((1.0f - apart * apart) * std::max(1.0f - own * own, 0.0f));
    all.cosine = std::min(all.cosine, apart * own - sines - 1e-5f);
  }
  return all;
}

TensorBounds together(std::span<const Cluster> clusters) {
  TensorBounds all;
  Matrix low;
  low.fill(std::numeric_limits<float>::infinity());
  Matrix high;
  high.fill(-std::numeric_limits<float>::infinity());
  for (const Cluster& cluster : clusters)
    for (std::size_t c = 0; cluster.candidateTriangles > 0 && c < 6; ++c) {
      low[c] = std::min(low[c], cluster.tensorBounds.middle[c]);
      high[c] = std::max(high[c], cluster.tensorBounds.middle[c]);
    }
  for (std::size_t c = 0; c < 6; ++c)
    all.middle[c] = low[c] <= high[c] ? 0.5f * (low[c] + high[c]) : 0.0f;
  for (const Cluster& cluster : clusters) {
    if (cluster.candidateTriangles == 0)
      continue;
    Matrix difference;
    for (std::size_t c = 0; c < 6; ++c)
      difference[c] = cluster.tensorBounds.middle[c] - all.middle[c];
    all.spread = std::max(all.spread, 1.0001f * (norm(difference) + cluster.tensorBounds.spread));
    all.largest = std::max(all.largest, cluster.tensorBounds.largest);
  }
  return all;
}

Cluster groupOf(std::span<const Cluster> clusters) {
  Cluster group{.firstTriangle = clusters.front().firstTriangle};
  Box box;
  glm::vec3 sum(0.0f);
  for (const Cluster& cluster : clusters) {
    group.triangleCount += cluster.triangleCount;
    group.candidateTriangles += cluster.candidateTriangles;
    box.add(cluster.bounds.centre);
    sum += cluster.cone.axis;
  }
  group.bounds.centre = box.centre();
  for (const Cluster& cluster : clusters)
    group.bounds.radius = std::max(
        group.bounds.radius, 1.0001f * (glm::distance(group.bounds.centre, cluster.bounds.centre) +
                                        cluster.bounds.radius));
  if (const float length = glm::length(sum); length > 0.0f)
    group.cone = coneOf(sum / length, clusters);
  group.tensorBounds = together(clusters);
  return group;
}

std::vector<Cluster> groupsOf(std::span<const Cluster> clusters) {
  constexpr std::size_t most = Clusters::itemsOfGroup;
  std::vector<Cluster> groups((clusters.size() + most - 1) / most);
  parallelFor(groups.size(), 64, [&](std::size_t i) {
    groups[i] = groupOf(clusters.subspan(i * most, std::min(most, clusters.size() - i * most)));
  });
  return groups;
}

/// Numbers the vertices of one cluster in the order in which its triangles use them.
class LocalNumbers {
 public:
  void start() { m_slots.fill(empty); }
  /// Returns the vertex's number; a new vertex is appended to `vertices`, which begin at `first`.
  std::uint8_t number(std::uint32_t vertex, std::vector<std::uint32_t>& vertices,
                      std::size_t first) {
    std::size_t slot = vertex * 2654435769u >> (32 - bits);
    while (m_slots[slot] != empty && vertices[first + m_slots[slot]] != vertex)
      slot = (slot + 1) & (m_slots.size() - 1);
    if (m_slots[slot] == empty) {
      m_slots[slot] = std::uint8_t(vertices.size() - first);
      vertices.push_back(vertex);
    }
    return m_slots[slot];
  }

 private:
  static constexpr int bits = 9;
  static constexpr std::uint8_t empty = 255;
  static_assert(Clusters::maximumVertices < empty);
  std::array<std::uint8_t, 1 << bits> m_slots{};
};

/// Makes a stretch of clusters; their vertices and samples are counted from its own first ones.
class Stretch {
 public:
  Stretch(const Source& source, Clusters& clusters) : m_source(source), m_clusters(clusters) {}

  void make(Cluster& cluster) {
    moveCandidatesFirst(cluster);
    cluster.firstVertex = std::uint32_t(vertices.size());
    cluster.firstSample = std::uint32_t(samples.size());
    m_numbers.start();
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      const std::uint32_t slot = cluster.firstTriangle + i;
      const Triangle& t = m_source.mesh.triangles()[m_clusters.triangles[slot]];
      for (std::size_t c = 0; c < 3; ++c)
        m_clusters.localTriangles[slot][c] = m_numbers.number(t[c], vertices, cluster.firstVertex);
      if (i + 1 == cluster.candidateTriangles)
        cluster.candidateVertices = std::uint32_t(vertices.size()) - cluster.firstVertex;
    }
    cluster.vertexCount = std::uint32_t(vertices.size()) - cluster.firstVertex;
    const std::span<const std::uint32_t> own(vertices.data() + cluster.firstVertex,
                                             cluster.vertexCount);
    boundShape(cluster, m_source, own, facesOf(cluster));
    samplePlaces(cluster, m_source, own, samples);
    cluster.tensorBounds = boundTensors(m_source, own.first(cluster.candidateVertices), samples);
  }

  std::vector<std::uint32_t> vertices;
  std::vector<std::uint8_t> samples;

 private:
  std::span<std::uint32_t> facesOf(const Cluster& cluster) {
    return {m_clusters.triangles.data() + cluster.firstTriangle, cluster.triangleCount};
  }

  void moveCandidatesFirst(Cluster& cluster) {
    std::array<std::uint32_t, Clusters::maximumTriangles> others;
    std::size_t count = 0;
    const std::span<std::uint32_t> faces = facesOf(cluster);
    for (const std::uint32_t f : faces)
      if (mayBend(m_source.vertices, m_source.mesh.triangles()[f]))
        faces[cluster.candidateTriangles++] = f;
      else
        others[count++] = f;
    std::copy_n(others.begin(), count, faces.begin() + cluster.candidateTriangles);
  }

  const Source& m_source;
  Clusters& m_clusters;
  LocalNumbers m_numbers;
};

constexpr std::size_t clustersPerStretch = 256;
}  // namespace

Clusters buildClusters(const Mesh& mesh, std::vector<std::uint32_t> order,
                       std::span<const SurfaceVertex> vertices) {
  const Source source{mesh, vertices};
  Clusters clusters;
  clusters.triangles = std::move(order);
  const std::size_t count = clusters.triangles.size();
  clusters.localTriangles.resize(count);
  constexpr std::size_t most = Clusters::maximumTriangles;
  clusters.items.resize((count + most - 1) / most);
  const std::size_t stretchCount =
      (clusters.items.size() + clustersPerStretch - 1) / clustersPerStretch;
  std::vector<Stretch> stretches(stretchCount, Stretch(source, clusters));
  const auto forEachOf = [&](std::size_t stretch, const auto& body) {
    const std::size_t end = std::min(clusters.items.size(), (stretch + 1) * clustersPerStretch);
    for (std::size_t i = stretch * clustersPerStretch; i < end; ++i)
      body(clusters.items[i], i);
  };
  parallelFor(stretches.size(), 1, [&](std::size_t s) {
    forEachOf(s, [&](Cluster& cluster, std::size_t i) {
      cluster.firstTriangle = std::uint32_t(i * most);
      cluster.triangleCount = std::uint32_t(std::min(most, count - i * most));
      stretches[s].make(cluster);
    });
  });
  std::size_t vertexCount = 0;
  std::size_t sampleCount = 0;
  for (const Stretch& stretch : stretches) {
    vertexCount += stretch.vertices.size();
    sampleCount += stretch.samples.size();
  }
  clusters.vertices.reserve(vertexCount);
  clusters.samples.reserve(sampleCount);
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    forEachOf(s, [&](Cluster& cluster, std::size_t) {
      cluster.firstVertex += std::uint32_t(clusters.vertices.size());
      cluster.firstSample += std::uint32_t(clusters.samples.size());
    });
    clusters.vertices.insert(clusters.vertices.end(), stretches[s].vertices.begin(),
                             stretches[s].vertices.end());
    clusters.samples.insert(clusters.samples.end(), stretches[s].samples.begin(),
                            stretches[s].samples.end());
    stretches[s].vertices = {};
    stretches[s].samples = {};
  }
  clusters.groups = groupsOf(clusters.items);
  return clusters;
}

Facing facing(const Sphere& bounds, const NormalCone& cone, const EyePoint& eye) {
  const glm::vec3 toEye = eye.atInfinity ? eye.value : eye.value - bounds.centre;
  const float distance = glm::length(toEye);
  // α is the opening of the normal cone; β is how much the line of sight turns within the bounding
  // sphere.
  const float sinBeta = eye.atInfinity ? 0.0f : bounds.radius / std::max(distance, 1e-30f);
  const float cosAlpha = cone.cosine;
  if (!(sinBeta < 1.0f) || !(cosAlpha > 0.0f))
    return Facing::mixed;
  const float cosBeta = std::sqrt(1.0f - sinBeta * sinBeta);
  const float sinAlpha = std::sqrt(std::max(0.0f, 1.0f - cosAlpha * cosAlpha));
  if (cosAlpha * cosBeta - sinAlpha * sinBeta <= 0.0f)
    return Facing::mixed;
  const float sinSum = sinAlpha * cosBeta + cosAlpha * sinBeta + 1e-5f;
  const float cosine = glm::dot(cone.axis, toEye) / distance;
  if (cosine > sinSum)
    return Facing::front;
  return cosine < -sinSum ? Facing::back : Facing::mixed;
}

}  // namespace sline::model
