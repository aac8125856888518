// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/pick_index.h"

#include <algorithm>
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
    const std::optional<model::Hit> hit = tree->nearest(ray);
    const bool surface = showsSurface(style);
    float& best = surface ? seenAt : outlinedAt;
    if (!hit || hit->t >= best)
      continue;
    best = hit->t;
    (surface ? seen : outlined) = Pick{node.id, ray.origin + hit->t * ray.direction};
  }
  std::erase_if(m_trees, [&](const auto& entry) { return !present.contains(entry.first); });
  return seen ? seen : outlined;
}

}  // namespace sline::widgets
