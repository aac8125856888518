// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/pick_index.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "model/geometry/spatial_order.h"

namespace sline::widgets {

namespace {

bool meets(const model::Ray& ray, const model::Box& box) {
  if (box.empty())
    return false;
  float enter = ray.nearest;
  float leave = ray.farthest;
  for (int i = 0; i < 3; ++i) {
    const float inverse = 1.0f / ray.direction[i];
    float a = (box.low[i] - ray.origin[i]) * inverse;
    float b = (box.high[i] - ray.origin[i]) * inverse;
    if (a > b)
      std::swap(a, b);
    // A ray within a face of the box gives NaN, which both comparisons pass over.
    enter = a > enter ? a : enter;
    leave = b < leave ? b : leave;
  }
  return enter <= leave;
}

/// What of the ray no section takes away.
model::Ray kept(model::Ray ray, std::span<const model::Section> sections) {
  for (const model::Section& section : sections) {
    const double from = section.plane.distance(ray.origin);
    const double slope = glm::dot(glm::dvec3(section.plane.normal), glm::dvec3(ray.direction));
    if (slope < 0.0)
      ray.nearest = std::max(ray.nearest, float(-from / slope));
    else if (slope > 0.0)
      ray.farthest = std::min(ray.farthest, float(-from / slope));
    else if (from > 0.0)
      ray.farthest = -std::numeric_limits<float>::infinity();
  }
  return ray;
}

/// Where the ray meets what is left of the mesh. A cut face has no triangles: a ray that enters at
/// a section and sees the surface from within came through one.
std::optional<float> meetsAt(const model::Bvh& tree, const model::Mesh& mesh, const model::Ray& ray,
                             float cutFrom) {
  if (!(ray.nearest <= ray.farthest))
    return std::nullopt;
  const std::optional<model::Hit> hit = tree.nearest(ray);
  if (!hit || !(ray.nearest > cutFrom))
    return hit ? std::optional(hit->t) : std::nullopt;
  const auto& [a, b, c] = mesh.triangles()[hit->triangle];
  const glm::vec3 normal = glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                      mesh.positions()[c] - mesh.positions()[a]);
  return glm::dot(normal, ray.direction) > 0.0f ? ray.nearest : hit->t;
}

bool showsSurface(const model::ResolvedStyle& style) {
  constexpr float suggestiveContours = 1.5f;  // the first of them appear
  return style.gamma.value() >= suggestiveContours || style.fill != model::Fill::none;
}

}  // namespace

std::optional<Pick> PickIndex::pick(const model::Scene& scene, const model::Ray& ray) {
  const std::lock_guard lock(m_mutex);
  std::set<model::MeshPtr> present;
  std::optional<Pick> seen;
  std::optional<Pick> outlined;
  float seenAt = ray.farthest;
  float outlinedAt = ray.farthest;
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    present.insert(node.mesh);
    const model::ResolvedStyle style = scene.resolve(node.id);
    if (!style.visible || !meets(ray, node.mesh->bounds()))
      continue;
    std::unique_ptr<model::Bvh>& tree = m_trees[node.mesh];
    if (!tree)
      tree = std::make_unique<model::Bvh>(node.mesh, model::spatialOrder(*node.mesh));
    const std::optional<float> at =
        meetsAt(*tree, *node.mesh, kept(ray, scene.sectionsOf(node.id)), ray.nearest);
    const bool surface = showsSurface(style);
    float& best = surface ? seenAt : outlinedAt;
    if (!at || *at >= best)
      continue;
    best = *at;
    (surface ? seen : outlined) = Pick{node.id, ray.origin + *at * ray.direction};
  }
  std::erase_if(m_trees, [&](const auto& entry) { return !present.contains(entry.first); });
  return seen ? seen : outlined;
}

}  // namespace sline::widgets
