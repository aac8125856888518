// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/sight.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {

bool seenFromWithin(const Mesh& mesh, const Hit& hit, const glm::vec3& direction) {
  const auto& [a, b, c] = mesh.triangles()[hit.triangle];
  const glm::vec3 normal = glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                      mesh.positions()[c] - mesh.positions()[a]);
  return glm::dot(normal, direction) > 0.0f;
}

}  // namespace

KeptSpan keptSpan(const Ray& ray, std::span<const Plane> planes) {
  KeptSpan kept{.nearest = double(ray.nearest), .farthest = double(ray.farthest)};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double outside = planes[i].distance(ray.origin);
    const double rise = glm::dot(glm::dvec3(planes[i].normal), glm::dvec3(ray.direction));
    const double at = -outside / rise;
    if (rise > 0.0 && at < kept.farthest) {
      kept.farthest = at;
      kept.left = i;
    } else if (rise < 0.0 && at > kept.nearest) {
      kept.nearest = at;
      kept.entered = i;
    } else if (rise == 0.0 && outside > 0.0) {
      kept.farthest = -std::numeric_limits<double>::infinity();
    }
  }
  return kept;
}

Ray keptPart(const Ray& ray, std::span<const Plane> planes) {
  const KeptSpan kept = keptSpan(ray, planes);
  Ray part = ray;
  part.nearest = float(kept.nearest);
  part.farthest = float(kept.farthest);
  return part;
}

bool reaches(const Ray& ray, const Box& box) {
  double enter = double(ray.nearest);
  double leave = double(ray.farthest);
  const double room = 1e-5 * double(glm::length(box.size()));
  for (int i = 0; i < 3; ++i) {
    const double low = double(box.low[i]) - room - double(ray.origin[i]);
    const double high = double(box.high[i]) + room - double(ray.origin[i]);
    const double along = double(ray.direction[i]);
    if (along == 0.0) {
      if (low > 0.0 || high < 0.0)
        return false;
      continue;
    }
    enter = std::max(enter, std::min(low / along, high / along));
    leave = std::min(leave, std::max(low / along, high / along));
  }
  return enter <= leave;
}

std::optional<CutHit> nearestKept(const Bvh& tree, const Ray& ray, std::span<const Plane> planes) {
  const Ray kept = keptPart(ray, planes);
  if (!(kept.nearest <= kept.farthest))
    return std::nullopt;
  const std::optional<Hit> hit = tree.nearest(kept);
  if (!hit)
    return std::nullopt;
  CutHit met{.hit = *hit};
  met.cutFace = kept.nearest > ray.nearest && seenFromWithin(tree.mesh(), *hit, ray.direction);
  if (met.cutFace)
    met.hit.t = kept.nearest;
  return met;
}

}  // namespace sline::model
