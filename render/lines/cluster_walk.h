// SPDX-License-Identifier: Apache-2.0
// Presents a cluster of a surface to the techniques that look for lines in it: how its vertices are
// seen from the eye, and where a value becomes zero along an edge. A technique walks over the
// cluster's triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/surface.h"
#include "render/lines/lines.h"
#include "render/lines/view_fields.h"

namespace sline::render {

/// A point on a triangle's edge through which a line may pass: it lies between the vertices `a` and
/// `b` of the cluster, at `share` of the way.
struct Crossing {
  glm::vec3 position;
  glm::vec3 normal;
  float nv;
  std::uint8_t a;
  std::uint8_t b;
  float share;

  /// Returns a value of the vertices at this point.
  template <class T>
  T mix(const T& atA, const T& atB) const {
    return atA + share * (atB - atA);
  }
};

/// Returns where along the edge a → b a value that is va at a and vb at b becomes zero, 0 … 1.
inline float zeroBetween(float va, float vb) {
  return std::clamp(va / (va - vb), 0.0f, 1.0f);
}

/// Walks over one cluster after the other, reusing its memory.
class ClusterWalk {
 public:
  using Field = std::array<float, model::Clusters::maximumVertices + 1>;
  using Local = std::array<std::uint8_t, 3>;  ///< a triangle's vertices by their numbers here

  ClusterWalk(const model::Surface& surface, const model::EyePoint& eye)
      : m_surface(surface), m_eye(eye) {}

  /// Looks at this cluster from now on.
  void enter(const model::Cluster& cluster);

  const model::Surface& surface() const { return m_surface; }
  const model::EyePoint& eye() const { return m_eye; }
  const model::Cluster& cluster() const { return *m_cluster; }
  const Local& local(std::uint32_t triangle) const {
    return m_surface.clusters.localTriangles[m_cluster->firstTriangle + triangle];
  }
  /// `triangle` returns the number that the cluster's triangle has in the mesh; `vertex` does so
  /// for a vertex.
  std::uint32_t triangle(std::uint32_t triangle) const {
    return m_surface.clusters.triangles[m_cluster->firstTriangle + triangle];
  }
  std::uint32_t vertex(std::uint8_t local) const {
    return m_surface.clusters.vertices[m_cluster->firstVertex + local];
  }

  // d is the vector to the eye, of any length, which is enough for signs.
  const Field& facing() const { return m_facing; }    ///< ⟨n, d⟩ = nv·|d|
  const Field& bending() const { return m_bending; }  ///< dᵀ·S·d = κr·|w|²·|d|²

  float nvAt(std::uint8_t local) const {
    return m_facing[local] / std::sqrt(m_distanceSquared[local]);
  }
  float radialCurvatureAt(std::uint8_t local) const {
    const float d2 = m_distanceSquared[local];
    const float w2 = d2 - m_facing[local] * m_facing[local];
    return m_bending[local] / std::max(w2, 1e-12f * d2);
  }

  /// Returns the corner with another sign than the two others; 3 where all are equal. Zero counts
  /// as positive, so every line passes from edge to edge.
  static std::size_t oddCorner(const Local& local, const Field& field) {
    const bool n0 = field[local[0]] < 0.0f;
    const bool n1 = field[local[1]] < 0.0f;
    const bool n2 = field[local[2]] < 0.0f;
    if (n0 == n1 && n1 == n2)
      return 3;
    return n1 == n2 ? 0 : n0 == n2 ? 1 : 2;
  }

  /// Returns where `valueAt` (of a vertex) becomes zero on the two edges at the odd corner.
  template <class ValueAt>
  std::array<Crossing, 2> ends(const Local& local, std::size_t odd, const ValueAt& valueAt) const {
    return {crossing(local[odd], local[(odd + 1) % 3], valueAt),
            crossing(local[odd], local[(odd + 2) % 3], valueAt)};
  }

 private:
  /// Returns where the value becomes zero on an edge. It always computes from the lower vertex
  /// number, so that both triangles at the edge get exactly the same point.
  template <class ValueAt>
  Crossing crossing(std::uint8_t a, std::uint8_t b, const ValueAt& valueAt) const {
    if (vertex(b) < vertex(a))
      std::swap(a, b);
    const float t = zeroBetween(valueAt(a), valueAt(b));
    const std::uint32_t va = vertex(a);
    const std::uint32_t vb = vertex(b);
    const auto mix = [t](const auto& x, const auto& y) { return x + t * (y - x); };
    const auto positions = m_surface.mesh->positions();
    return {.position = mix(positions[va], positions[vb]),
            .normal = mix(m_surface.normals[va], m_surface.normals[vb]),
            .nv = mix(nvAt(a), nvAt(b)),
            .a = a,
            .b = b,
            .share = t};
  }

  const model::Surface& m_surface;
  const model::EyePoint& m_eye;
  const model::Cluster* m_cluster = nullptr;
  Field m_distanceSquared;
  Field m_facing;
  Field m_bending;
};

}  // namespace sline::render
