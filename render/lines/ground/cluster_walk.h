// SPDX-License-Identifier: Apache-2.0
// Presents a cluster of a surface to the techniques that look for lines in it: how its vertices are
// seen from the eye, and where a value becomes zero along an edge. A technique walks over the
// cluster's triangles. What the mesh says of a vertex is looked at when it is first asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "model/geometry/surface.h"
#include "render/lines/ground/segments.h"
#include "render/lines/ground/view_fields.h"

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

/// Tells which of a cluster's vertices have a negative value.
class Signs {
 public:
  /// Takes the signs of the vertices' values; returns whether both occur. Zero counts as positive,
  /// so every line passes from edge to edge.
  bool take(std::span<const float> values) {
    unsigned negative = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      m_negative[i] = values[i] < 0.0f ? 1 : 0;
      negative += m_negative[i];
    }
    return negative != 0 && negative != values.size();
  }

  /// A triangle of the cluster with a corner of another sign than the two others.
  struct Crossed {
    std::uint8_t triangle;
    std::uint8_t odd;
  };
  /// Lists them. The loop has no branches that the processor could guess wrong.
  std::span<const Crossed> crossed(std::span<const std::array<std::uint8_t, 3>> triangles) {
    constexpr std::array<std::uint8_t, 8> oddCorner{3, 0, 1, 2, 2, 1, 0, 3};
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      const std::uint8_t odd =
          oddCorner[std::size_t(m_negative[a] + 2 * m_negative[b] + 4 * m_negative[c])];
      m_crossed[count] = {std::uint8_t(i), odd};
      count += odd < 3 ? 1 : 0;
    }
    return {m_crossed.data(), count};
  }

 private:
  std::array<std::uint8_t, model::Clusters::maximumVertices> m_negative;
  std::array<Crossed, model::Clusters::maximumTriangles + 1> m_crossed;
};

/// Returns where along the edge a → b a value that is va at a and vb at b becomes zero, 0 … 1.
inline float zeroBetween(float va, float vb) {
  return std::clamp(va / (va - vb), 0.0f, 1.0f);
}

/// Walks over one cluster after the other, reusing its memory.
class ClusterWalk {
 public:
  using Field = std::array<float, model::Clusters::maximumVertices>;
  using Local = std::array<std::uint8_t, 3>;  ///< a triangle's vertices by their numbers here

  ClusterWalk(const model::Surface& surface, const model::EyePoint& eye)
      : m_surface(surface), m_eye(eye) {}

  /// Looks at this cluster from now on.
  void enter(const model::Cluster& cluster);

  const model::Surface& surface() const { return m_surface; }
  const model::EyePoint& eye() const { return m_eye; }
  const model::Cluster& cluster() const { return *m_cluster; }
  /// Returns the cluster's first triangles.
  std::span<const Local> locals(std::uint32_t count) const {
    return {m_surface.clusters.localTriangles.data() + m_cluster->firstTriangle, count};
  }
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

  /// Returns the cluster's samples (model::Clusters).
  const std::uint8_t* samples() const {
    return m_surface.clusters.samples.data() + m_cluster->firstSample;
  }

  const model::SurfaceVertex& shapeAt(std::uint8_t local) const {
    return m_surface.vertices[vertex(local)];
  }
  /// Replaces those of the first vertices' values whose sign is open, as they lie within ±`open`,
  /// by what `exact` returns for a vertex.
  template <class Exact>
  void settle(std::span<float> values, float open, const Exact& exact) const {
    std::array<std::uint8_t, model::Clusters::maximumVertices> left;
    std::size_t leftCount = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      left[leftCount] = std::uint8_t(i);
      leftCount += std::abs(values[i]) > open ? 0 : 1;
    }
    for (std::size_t i = 0; i < leftCount; ++i)
      fetch(left[i]);
    for (std::size_t i = 0; i < leftCount; ++i)
      values[left[i]] = exact(left[i]);
  }
  /// Has the processor fetch a vertex that will be looked at soon.
  void fetch(std::uint8_t local) const { __builtin_prefetch(&shapeAt(local)); }

  // d is the vector to the eye, of any length, which is enough for signs.
  /// Returns ⟨n, d⟩ = nv·|d| of all vertices.
  std::span<const float> facing() const {
    if (!m_lookedAtAll)
      lookAtAll();
    return {m_facing.data(), m_cluster->vertexCount};
  }
  float facingAt(std::uint8_t local) const {
    if (!m_lookedAt[local])
      lookAt(local);
    return m_facing[local];
  }
  /// Returns dᵀ·S·d = κr·|w|²·|d|².
  float bendingAt(std::uint8_t local) const {
    const model::SurfaceVertex& v = shapeAt(local);
    return bendingTowards(v.normal, v.e1, v.k, vectorTo(m_eye, v.position));
  }

  float nvAt(std::uint8_t local) const {
    const float facing = facingAt(local);
    return cosineOf(facing, m_distanceSquared[local]);
  }

  /// Returns where `valueAt` (of a vertex) becomes zero on the two edges at the odd corner.
  template <class ValueAt>
  std::array<Crossing, 2> ends(const Local& local, std::size_t odd, const ValueAt& valueAt) const {
    return ends(local, odd, valueAt, [this](std::uint8_t vertex) { return nvAt(vertex); });
  }
  /// Does so where nv is known, too.
  template <class ValueAt, class NvAt>
  std::array<Crossing, 2> ends(const Local& local, std::size_t odd, const ValueAt& valueAt,
                               const NvAt& nvOf) const {
    return {crossing(local[odd], local[(odd + 1) % 3], valueAt, nvOf),
            crossing(local[odd], local[(odd + 2) % 3], valueAt, nvOf)};
  }

 private:
  /// Returns where the value becomes zero on an edge. It always computes from the lower vertex
  /// number, so that both triangles at the edge get exactly the same point.
  template <class ValueAt, class NvAt>
  Crossing crossing(std::uint8_t a, std::uint8_t b, const ValueAt& valueAt,
                    const NvAt& nvOf) const {
    if (vertex(b) < vertex(a))
      std::swap(a, b);
    const float t = zeroBetween(valueAt(a), valueAt(b));
    const model::SurfaceVertex& va = shapeAt(a);
    const model::SurfaceVertex& vb = shapeAt(b);
    const auto mix = [t](const auto& x, const auto& y) { return x + t * (y - x); };
    return {.position = mix(va.position, vb.position),
            .normal = mix(va.normal, vb.normal),
            .nv = mix(nvOf(a), nvOf(b)),
            .a = a,
            .b = b,
            .share = t};
  }

  void lookAt(std::uint8_t local) const {
    m_lookedAt[local] = true;
    const model::SurfaceVertex& v = shapeAt(local);
    const glm::vec3 d = vectorTo(m_eye, v.position);
    m_distanceSquared[local] = glm::dot(d, d);
    m_facing[local] = glm::dot(v.normal, d);
  }
  void lookAtAll() const;

  const model::Surface& m_surface;
  const model::EyePoint& m_eye;
  const model::Cluster* m_cluster = nullptr;
  // What is known of the vertices so far; a walk belongs to one thread.
  mutable std::array<bool, model::Clusters::maximumVertices> m_lookedAt;
  mutable bool m_lookedAtAll = false;
  mutable Field m_distanceSquared;
  mutable Field m_facing;
};

}  // namespace sline::render
