// SPDX-License-Identifier: Apache-2.0
#include "render/picking/pick_index.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "model/camera/camera_moves.h"
#include "model/cuts/plane_section.h"
#include "model/geometry/sight.h"
#include "model/scene/resolved_styles.h"
#include "render/drawn/section_caps.h"
#include "render/drawn/surface_fill.h"

namespace sline::render {

namespace {

/// Tells how much of what is behind a structure can be seen; `lines` is one drawn by suggestive
/// contours or more, between which most of it can.
enum class Body { outline, veil, lines, solid };

Body bodyOf(const model::ResolvedStyle& style) {
  constexpr float suggestiveContours = 1.5f;  // the first of them appear
  constexpr float thin = 0.35f;  // what hides less does not win against what shines through
  const bool told = style.gamma.value() >= suggestiveContours;
  if (!told && style.fill == model::Fill::none)
    return Body::outline;
  if (style.opacity.value() < thin)
    return Body::veil;
  if (fillCover(style) >= thin && (told || style.fill != model::Fill::veil))
    return Body::solid;
  return told ? Body::lines : Body::veil;
}

/// A structure that is found at the place.
struct Found {
  Pick pick;
  Body body = Body::solid;
  float at = 0.0f;       ///< along the ray
  float order = 0.0f;    ///< the same, but that faces of one cut lie as in pictures
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
  if (found.body != Body::solid && found.outline && found.order <= solidAt)
    return 0;
  if (found.body == Body::solid)
    return found.within ? 1 : 3;
  if (found.body == Body::lines && found.within)
    return 2;
  if (found.body == Body::veil && found.within)
    return 4;
  return 5;
}

std::optional<Pick> seenOf(const std::vector<Found>& found) {
  float solidAt = std::numeric_limits<float>::infinity();
  for (const Found& one : found)
    if (one.body == Body::solid && one.within)
      solidAt = std::min(solidAt, one.order);
  const auto first =
      std::min_element(found.begin(), found.end(), [solidAt](const Found& a, const Found& b) {
        return std::pair(rank(a, solidAt), a.order) < std::pair(rank(b, solidAt), b.order);
      });
  return first == found.end() ? std::nullopt : std::optional(first->pick);
}

/// A structure that can be picked.
struct Candidate {
  const model::Node* node = nullptr;
  Body body = Body::solid;
  std::vector<model::Plane> planes;
};

std::vector<Candidate> candidates(const model::Scene& scene) {
  std::vector<Candidate> found;
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const model::Node& node = scene.nodes()[i];
    if (!node.isGroup() && styles[i].visible && styles[i].opacity.value() > 0.0f &&
        !scene.isLocked(node.id))
      found.push_back({&node, bodyOf(styles[i]), model::planesOf(scene.sectionsOf(node.id))});
  }
  return found;
}

/// Finds what is seen in a box of the picture.
class BoxSearch {
 public:
  BoxSearch(const PickIndex::Box& box, std::span<const Candidate> all, model::MeshTrees& trees)
      : m_box(box), m_all(all), m_trees(trees) {}

  bool finds(const Candidate& candidate) const {
    // A ray exactly through a vertex may slip between the triangles of another surface there.
    constexpr glm::vec2 beside(0.017f, 0.011f);
    std::vector<glm::vec2> places;
    const std::vector<glm::vec3> points =
        model::keptPoints(*candidate.node->mesh, candidate.planes);
    for (const glm::vec3& p : points)
      if (const auto pixel = pixelOf(m_box.camera, p, m_box.size); pixel && holds(*pixel))
        places.push_back(*pixel + beside);
    if (points.empty() || (!m_box.touching && places.size() < points.size()))
      return false;
    // What hides a structure wholly is asked for at so many places at most.
    constexpr std::size_t most = 200;
    const std::size_t step = std::max<std::size_t>(1, places.size() / most);
    for (std::size_t i = 0; i < places.size(); i += step)
      if (seenAt(places[i], candidate))
        return true;
    // Large triangles have their corners elsewhere.
    constexpr int rows = 16;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < rows; ++column) {
        const glm::vec2 part = (glm::vec2(column, row) + 0.5f) / float(rows);
        if (seenAt(m_box.low + part * (m_box.high - m_box.low), candidate))
          return true;
      }
    return false;
  }

 private:
  bool holds(const glm::vec2& pixel) const {
    return pixel.x >= m_box.low.x && pixel.y >= m_box.low.y && pixel.x <= m_box.high.x &&
           pixel.y <= m_box.high.y;
  }
  std::optional<float> meet(const model::Ray& ray, const Candidate& candidate) const {
    if (!model::reaches(ray, candidate.node->mesh->bounds()))
      return std::nullopt;
    const auto met = model::nearestKept(m_trees.of(candidate.node->mesh), ray, candidate.planes);
    return met ? std::optional(met->hit.t) : std::nullopt;
  }
  bool seenAt(const glm::vec2& pixel, const Candidate& candidate) const {
    const model::Ray ray = sightThrough(m_box.camera, pixel, m_box.size);
    const std::optional<float> own = meet(ray, candidate);
    return own && std::none_of(m_all.begin(), m_all.end(), [&](const Candidate& other) {
             const bool hides = other.body == Body::solid && other.node != candidate.node;
             return hides && meet(ray, other).value_or(*own) < *own;
           });
  }

  const PickIndex::Box& m_box;
  std::span<const Candidate> m_all;
  model::MeshTrees& m_trees;
};

}  // namespace

std::optional<float> PickIndex::faceAt(const model::Scene& scene, const model::Node& node,
                                       std::span<const model::Plane> planes,
                                       const model::Ray& ray) {
  if (planes.empty() || !m_trees.solid(node.mesh))
    return std::nullopt;
  const std::optional<model::CutHit> met = model::nearestKept(m_trees.of(node.mesh), ray, planes);
  const std::optional<std::size_t> entered = model::keptSpan(ray, planes).entered;
  if (!met || !met->cutFace || !entered)
    return std::nullopt;
  return faceSteps(model::sectionArea(*node.mesh, planes[*entered]), scene.visibleBounds().size());
}

Picks PickIndex::pick(const model::Scene& scene, std::span<const model::Ray> rays) {
  const std::lock_guard lock(m_mutex);
  std::vector<Found> found;
  for (const Candidate& candidate : candidates(scene)) {
    const model::Node& node = *candidate.node;
    if (!near(rays, node.mesh->bounds()))
      continue;
    const std::optional<float> steps = faceAt(scene, node, candidate.planes, rays.front());
    const bool hides = steps && candidate.body != Body::veil;
    auto one = Probe(m_trees.of(node.mesh), candidate.planes)
                   .at(rays, hides ? Body::solid : candidate.body);
    if (!one)
      continue;
    one->order = inFront(one->at, steps.value_or(0.0f));
    one->pick = {node.id, rays.front().origin + one->at * rays.front().direction};
    found.push_back(*one);
  }
  m_trees.keepOnly(model::meshesOf(scene));
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.order < b.order; });
  Picks picks{.seen = seenOf(found), .all = {}};
  for (const Found& one : found)
    picks.all.push_back(one.pick);
  return picks;
}

std::vector<model::NodeId> PickIndex::inBox(const model::Scene& scene, const Box& box) {
  const std::lock_guard lock(m_mutex);
  const std::vector<Candidate> all = candidates(scene);
  std::vector<model::NodeId> found;
  const BoxSearch search(box, all, m_trees);
  for (const Candidate& candidate : all)
    if (search.finds(candidate))
      found.push_back(candidate.node->id);
  m_trees.keepOnly(model::meshesOf(scene));
  return found;
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

std::vector<model::Ray> sightsAround(const model::Camera& camera, const glm::vec2& pixel,
                                     const glm::vec2& size) {
  constexpr float reach = 4.0f;  // pixels: as near as a hand comes to a line
  constexpr float diagonal = 0.70710678f * reach;
  constexpr std::array<std::array<float, 2>, 9> steps{{{0, 0},
                                                       {reach, 0},
                                                       {diagonal, diagonal},
                                                       {0, reach},
                                                       {-diagonal, diagonal},
                                                       {-reach, 0},
                                                       {-diagonal, -diagonal},
                                                       {0, -reach},
                                                       {diagonal, -diagonal}}};
  std::vector<model::Ray> rays;
  rays.reserve(steps.size());
  for (const auto& [x, y] : steps)
    rays.push_back(sightThrough(camera, pixel + glm::vec2(x, y), size));
  return rays;
}

}  // namespace sline::render
