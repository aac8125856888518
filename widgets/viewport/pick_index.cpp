// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/pick_index.h"

#include <algorithm>
#include <array>
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

/// How a structure lets what is behind it be seen.
enum class Body { outline, veil, solid };

Body bodyOf(const model::ResolvedStyle& style) {
  constexpr float suggestiveContours = 1.5f;  // the first of them appear
  constexpr float thin = 0.4f;                // more of what is behind is seen than of the surface
  const bool told = style.gamma.value() >= suggestiveContours;
  if (!told && style.fill == model::Fill::none)
    return Body::outline;
  if (style.opacity.value() < thin || (!told && style.fill == model::Fill::veil))
    return Body::veil;
  return Body::solid;
}

/// One structure at the place.
struct Found {
  Pick pick;
  Body body = Body::solid;
  float at = 0.0f;       ///< along the ray
  bool within = true;    ///< the middle ray meets it, not only one around
  bool outline = false;  ///< its outline passes there
};

/// Where the rays meet what is left of one mesh.
class Probe {
 public:
  Probe(const model::Bvh& tree, const model::Mesh& mesh, std::span<const model::Section> sections)
      : m_tree(tree), m_mesh(mesh), m_sections(sections) {}

  std::optional<Found> at(std::span<const model::Ray> rays, Body body) const {
    Found found{.body = body};
    const std::optional<float> middle = meet(rays.front());
    found.within = middle.has_value();
    // A solid one that is met needs no line to be seen by.
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
    if (!meets(ray, m_mesh.bounds()))
      return std::nullopt;
    return meetsAt(m_tree, m_mesh, kept(ray, m_sections), ray.nearest);
  }
  /// A step in depth between neighbouring rays that no surface makes unless one part of it stands
  /// before another: seen at less than 5°.
  static float fold(std::span<const model::Ray> rays, float at) {
    constexpr float steep = 12.0f;
    const auto point = [at](const model::Ray& ray) { return ray.origin + at * ray.direction; };
    return steep * 2.0f * glm::length(point(rays[1]) - point(rays[0]));
  }

  const model::Bvh& m_tree;
  const model::Mesh& m_mesh;
  std::span<const model::Section> m_sections;
};

bool near(std::span<const model::Ray> rays, const model::Box& box) {
  return std::any_of(rays.begin(), rays.end(),
                     [&](const model::Ray& ray) { return meets(ray, box); });
}

/// The place in the order of what is seen; smaller comes first, then what is nearer.
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

const model::Bvh& PickIndex::treeOf(const model::MeshPtr& mesh) {
  std::unique_ptr<model::Bvh>& tree = m_trees[mesh];
  if (!tree)
    tree = std::make_unique<model::Bvh>(mesh, model::spatialOrder(*mesh));
  return *tree;
}

Picks PickIndex::look(const model::Scene& scene, std::span<const model::Ray> rays) {
  const std::lock_guard lock(m_mutex);
  std::set<model::MeshPtr> present;
  std::vector<Found> found;
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    present.insert(node.mesh);
    if (!near(rays, node.mesh->bounds()))
      continue;
    const model::ResolvedStyle style = scene.resolve(node.id);
    if (!style.visible || style.opacity.value() <= 0.0f || scene.isLocked(node.id))
      continue;
    const std::vector<model::Section> sections = scene.sectionsOf(node.id);
    auto one = Probe(treeOf(node.mesh), *node.mesh, sections).at(rays, bodyOf(style));
    if (!one)
      continue;
    one->pick = {node.id, rays.front().origin + one->at * rays.front().direction};
    found.push_back(*one);
  }
  std::erase_if(m_trees, [&](const auto& entry) { return !present.contains(entry.first); });
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.at < b.at; });
  Picks picks{.seen = seenOf(found), .all = {}};
  for (const Found& one : found)
    picks.all.push_back(one.pick);
  return picks;
}

std::optional<Pick> deeper(const std::vector<Pick>& all, std::span<const model::NodeId> selection) {
  if (all.empty())
    return std::nullopt;
  if (selection.size() != 1)
    return all.front();
  const auto now = std::find_if(all.begin(), all.end(),
                                [&](const Pick& pick) { return pick.id == selection.front(); });
  return now == all.end() || now + 1 == all.end() ? all.front() : *(now + 1);
}

}  // namespace sline::widgets
