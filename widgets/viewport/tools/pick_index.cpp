// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/tools/pick_index.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "model/geometry/sight.h"

namespace sline::widgets {

namespace {

/// Tells how much of what is behind a structure can be seen.
enum class Body { outline, veil, solid };

Body bodyOf(const model::ResolvedStyle& style) {
  constexpr float suggestiveContours = 1.5f;  // the first of them appear
  constexpr float thin = 0.4f;  // more can be seen of what is behind than of the surface
  const bool told = style.gamma.value() >= suggestiveContours;
  if (!told && style.fill == model::Fill::none)
    return Body::outline;
  if (style.opacity.value() < thin || (!told && style.fill == model::Fill::veil))
    return Body::veil;
  return Body::solid;
}

/// A structure that is found at the place.
struct Found {
  Pick pick;
  Body body = Body::solid;
  float at = 0.0f;       ///< along the ray
  bool within = true;    ///< the middle ray meets it, not only one around
  bool outline = false;  ///< its outline passes there
};

/// Finds where the rays meet what is left of one mesh.
class Probe {
 public:
  Probe(const model::Bvh& tree, std::span<const model::Plane> planes)
      : m_tree(tree), m_planes(planes) {}

  std::optional<Found> at(std::span<const model::Ray> rays, Body body) const {
    Found found{.body = body};
    const std::optional<float> middle = meet(rays.front());
    found.within = middle.has_value();
    // A solid structure that the middle ray meets is seen without any line.
    if (middle && body == Body::solid) {
      found.at = *middle;
      return found;
    }
    int met = 0;
    float nearest = middle.value_or(std::numeric_limits<float>::infinity());
    float farthest = middle.value_or(0.0f);
    for (const model::Ray& ray : rays.subspan(1))
      if (const std::optional<float> t = meet(ray)) {
        ++met;
        nearest = std::min(nearest, *t);
        farthest = std::max(farthest, *t);
      }
    if (!middle && met == 0)
      return std::nullopt;
    found.at = middle.value_or(nearest);
    const int around = int(rays.size()) - 1;
    found.outline = met < around || (around > 0 && !middle) ||
                    (around > 0 && farthest - nearest > fold(rays, found.at));
    return found;
  }

 private:
  std::optional<float> meet(const model::Ray& ray) const {
    if (!model::reaches(ray, m_tree.mesh().bounds()))
      return std::nullopt;
    const std::optional<model::CutHit> met = model::nearestKept(m_tree, ray, m_planes);
    return met ? std::optional(met->hit.t) : std::nullopt;
  }
  /// Returns a step in depth between neighbouring rays that no surface makes unless one part of it
  /// stands before another: seen at less than 5°.
  static float fold(std::span<const model::Ray> rays, float at) {
    constexpr float steep = 12.0f;
    const auto point = [at](const model::Ray& ray) { return ray.origin + at * ray.direction; };
    return steep * 2.0f * glm::length(point(rays[1]) - point(rays[0]));
  }

  const model::Bvh& m_tree;
  std::span<const model::Plane> m_planes;
};

bool near(std::span<const model::Ray> rays, const model::Box& box) {
  return std::any_of(rays.begin(), rays.end(),
                     [&](const model::Ray& ray) { return model::reaches(ray, box); });
}

/// Returns the place in the order of what is seen; smaller comes first, then what is nearer.
int rank(const Found& found, float solidAt) {
  if (found.body != Body::solid && found.outline && found.at <= solidAt)
    return 0;
  if (found.body == Body::solid)
    return found.within ? 1 : 2;
  if (found.body == Body::veil && found.within)
    return 3;
  return 4;
}

std::optional<Pick> seenOf(const std::vector<Found>& found) {
  float solidAt = std::numeric_limits<float>::infinity();
  for (const Found& one : found)
    if (one.body == Body::solid && one.within)
      solidAt = std::min(solidAt, one.at);
  const auto first =
      std::min_element(found.begin(), found.end(), [solidAt](const Found& a, const Found& b) {
        return std::pair(rank(a, solidAt), a.at) < std::pair(rank(b, solidAt), b.at);
      });
  return first == found.end() ? std::nullopt : std::optional(first->pick);
}

}  // namespace

Picks PickIndex::pick(const model::Scene& scene, std::span<const model::Ray> rays) {
  const std::lock_guard lock(m_mutex);
  std::vector<Found> found;
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    if (!near(rays, node.mesh->bounds()))
      continue;
    const model::ResolvedStyle style = scene.resolve(node.id);
    if (!style.visible || style.opacity.value() <= 0.0f || scene.isLocked(node.id))
      continue;
    const std::vector<model::Plane> planes = model::planesOf(scene.sectionsOf(node.id));
    auto one = Probe(m_trees.of(node.mesh), planes).at(rays, bodyOf(style));
    if (!one)
      continue;
    one->pick = {node.id, rays.front().origin + one->at * rays.front().direction};
    found.push_back(*one);
  }
  m_trees.keepOnly(model::meshesOf(scene));
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.at < b.at; });
  Picks picks{.seen = seenOf(found), .all = {}};
  for (const Found& one : found)
    picks.all.push_back(one.pick);
  return picks;
}

std::optional<Pick> nextDeeper(const std::vector<Pick>& all,
                               std::span<const model::NodeId> selection) {
  if (all.empty())
    return std::nullopt;
  if (selection.size() != 1)
    return all.front();
  const auto now = std::find_if(all.begin(), all.end(),
                                [&](const Pick& pick) { return pick.id == selection.front(); });
  return now == all.end() || now + 1 == all.end() ? all.front() : *(now + 1);
}

}  // namespace sline::widgets
