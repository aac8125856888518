// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/visibility.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/sight.h"
#include "render/lines/ground/view_fields.h"

namespace sline::render {

namespace {
/// Contours run where normals, not polygons, turn away: they may lie below the polygons' own edge
/// by a fraction of a triangle. Rays therefore start a little above the surface and ignore anything
/// nearer than one edge of the segment's triangle.
constexpr float liftInEdges = 0.1f;
constexpr float overlookedInEdges = 1.0f;

float longestEdge(const model::Mesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const auto p = mesh.positions();
  return std::max(
      {glm::distance(p[a], p[b]), glm::distance(p[b], p[c]), glm::distance(p[c], p[a])});
}

/// Tells whether the point of the face's plane lies in one of its triangles.
bool onCap(const CutFace& face, const glm::dvec3& p) {
  const glm::dvec3 normal(face.plane.normal);
  for (std::size_t i = 0; i + 2 < face.cap.size(); i += 3) {
    const std::array<glm::dvec3, 3> corners{face.cap[i], face.cap[i + 1], face.cap[i + 2]};
    const auto leftOf = [&](std::size_t k) {
      const glm::dvec3& a = corners[k];
      return glm::dot(glm::cross(corners[(k + 1) % 3] - a, p - a), normal) >= 0.0;
    };
    if (leftOf(0) && leftOf(1) && leftOf(2))
      return true;
  }
  return false;
}

/// Holds what lies in the way of rays: the surface where it is kept, and the faces of its cuts.
class Obstacles {
 public:
  Obstacles(const model::Bvh& bvh, std::span<const CutFace> faces) : m_bvh(bvh), m_faces(faces) {
    for (const CutFace& face : faces)
      m_planes.push_back(face.plane);
  }

  bool block(const model::Ray& ray) const {
    const model::KeptSpan span = model::keptSpan(ray, m_planes);
    if (!(span.nearest < span.farthest))
      return false;
    const auto at = [&ray](double t) {
      return glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction);
    };
    model::Ray kept = ray;
    kept.nearest = float(span.nearest);
    kept.farthest = float(span.farthest);
    return m_bvh.blocked(kept) ||
           (span.entered && onCap(m_faces[*span.entered], at(span.nearest))) ||
           (span.left && onCap(m_faces[*span.left], at(span.farthest)));
  }

 private:
  const model::Bvh& m_bvh;
  std::span<const CutFace> m_faces;
  std::vector<model::Plane> m_planes;  ///< those of the faces
};

/// Calls test(segment index, middle of the segment, unit normal there, edge length) in parallel.
template <class Test>
std::vector<bool> testSegments(const model::Surface& surface, const std::vector<Segment>& segments,
                               const Test& test) {
  std::vector<char> results(segments.size());
  parallelFor(segments.size(), 64, [&](std::size_t i) {
    const Segment& s = segments[i];
    const glm::vec3 normal = glm::normalize(s.normalA + s.normalB);
    results[i] = test(0.5f * (s.a + s.b), normal, longestEdge(*surface.mesh, s.triangle));
  });
  return {results.begin(), results.end()};
}

/// Tells whether there is nothing between the eye and the surface at p with unit normal n.
bool isVisible(const Obstacles& obstacles, const model::EyePoint& eye, const glm::vec3& p,
               const glm::vec3& n, float edge) {
  const glm::vec3 origin = p + liftInEdges * edge * n;
  const float distance =
      eye.atInfinity ? std::numeric_limits<float>::infinity() : glm::distance(eye.value, origin);
  return !obstacles.block({.origin = origin,
                           .direction = directionTo(eye, origin),
                           .nearest = overlookedInEdges * edge,
                           .farthest = distance});
}
}  // namespace

std::vector<bool> visibleSegments(const model::Surface& surface, const model::Bvh& bvh,
                                  const model::Camera& camera, const std::vector<Segment>& segments,
                                  std::span<const CutFace> faces) {
  const model::EyePoint eye = eyeOf(camera);
  const Obstacles obstacles(bvh, faces);
  return testSegments(surface, segments, [&](const glm::vec3& p, const glm::vec3& n, float edge) {
    return isVisible(obstacles, eye, p, n, edge);
  });
}

std::vector<bool> visiblePoints(const model::Surface& surface, const model::Bvh& bvh,
                                const model::Camera& camera, const Hatching& hatching,
                                std::span<const CutFace> faces) {
  const model::EyePoint eye = eyeOf(camera);
  const Obstacles obstacles(bvh, faces);
  std::vector<char> results(hatching.points.size());
  parallelFor(hatching.points.size(), 64, [&](std::size_t i) {
    const HatchPoint& point = hatching.points[i];
    results[i] = isVisible(obstacles, eye, point.position, point.normal, surface.meanEdge);
  });
  return {results.begin(), results.end()};
}

std::vector<bool> silhouetteSegments(const model::Surface& surface, const model::Bvh& bvh,
                                     const model::Camera& camera,
                                     const std::vector<Segment>& contours,
                                     std::span<const CutFace> faces) {
  const model::EyePoint eye = eyeOf(camera);
  const Obstacles obstacles(bvh, faces);
  return testSegments(surface, contours, [&](const glm::vec3& p, const glm::vec3& n, float edge) {
    const glm::vec3 beside = p + 2.0f * liftInEdges * edge * n;
    const glm::vec3 direction = directionTo(eye, beside);
    model::Ray ray{.origin = beside, .direction = direction};
    if (eye.atInfinity)
      ray.nearest = -std::numeric_limits<float>::max();
    else
      ray = {.origin = eye.value, .direction = -direction};
    return !obstacles.block(ray);
  });
}

}  // namespace sline::render
