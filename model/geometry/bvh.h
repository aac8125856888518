// SPDX-License-Identifier: Apache-2.0
// Builds a bounding-volume hierarchy for rays and distances: a balanced binary tree over the
// spatial order, which takes only a few passes over the triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// A ray is origin + t·direction for t in [nearest, farthest]; the direction need not be a unit
/// vector.
struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, 0.0f, 1.0f};
  float nearest = 0.0f;
  float farthest = std::numeric_limits<float>::infinity();
};

struct Hit {
  float t = 0.0f;
  std::uint32_t triangle = 0;
  float u = 0.0f;  ///< barycentric weights of the triangle's second and third vertex
  float v = 0.0f;
};

/// Holds the point of a surface nearest to another point.
struct Closest {
  float distance = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = 0;
};

class Bvh {
 public:
  Bvh(MeshPtr mesh, std::vector<std::uint32_t> order);

  const Mesh& mesh() const { return *m_mesh; }
  /// Returns the first hit along the ray; both sides of a triangle count.
  std::optional<Hit> nearest(const Ray& ray) const;
  /// Tells whether the ray hits any triangle.
  bool blocked(const Ray& ray) const;
  /// Returns the closest point, infinitely far away where no triangle is nearer than `farthest`.
  /// Any triangle no farther than `enough` may be returned as the closest.
  Closest closest(const glm::vec3& point, float enough = 0.0f,
                  float farthest = std::numeric_limits<float>::infinity()) const;
  /// Tells whether the surface is nearer to the point than that, which is sooner known than how
  /// near.
  bool isWithin(const glm::vec3& point, float distance) const;

 private:
  struct Bounds {
    glm::vec3 low;
    glm::vec3 high;
  };
  template <class Visit>
  void traverse(const Ray& ray, const Visit& visit) const;
  template <class Choice, class Visit>
  void traverseBy(const Ray& ray, const Visit& visit) const;

  MeshPtr m_mesh;
  std::vector<std::uint32_t> m_order;
  std::vector<Bounds> m_nodes;    ///< node i has children 2i+1 and 2i+2
  std::uint32_t m_leafCount = 0;  ///< a power of two
};

}  // namespace sline::model
