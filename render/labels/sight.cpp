// SPDX-License-Identifier: Apache-2.0
#include "render/labels/sight.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "model/geometry/spatial_order.h"
#include "model/scene/resolved_styles.h"

namespace sline::render {

namespace {

bool hidesWhatIsBehind(const model::ResolvedStyle& style) {
  constexpr float shaded = 3.5f;  // half way from hatching to shading
  constexpr float thin = 0.4f;
  const bool filled = style.gamma.value() >= shaded || style.fill == model::Fill::paper;
  return filled && style.opacity.value() >= thin;
}

/// The part of the ray that the planes keep.
model::Ray keptPart(model::Ray ray, std::span<const model::Plane> planes) {
  for (const model::Plane& plane : planes) {
    const double outside = plane.distance(ray.origin);
    const double rise = glm::dot(glm::dvec3(plane.normal), glm::dvec3(ray.direction));
    if (rise > 0.0)
      ray.farthest = std::min(ray.farthest, float(-outside / rise));
    else if (rise < 0.0)
      ray.nearest = std::max(ray.nearest, float(-outside / rise));
    else if (outside > 0.0)
      ray.farthest = -std::numeric_limits<float>::infinity();
  }
  return ray;
}

/// The ray meets the box: what it does not meet needs no tree.
bool reaches(const model::Ray& ray, const model::Box& box) {
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

bool seenFromWithin(const model::Mesh& mesh, const model::Hit& hit, const glm::vec3& direction) {
  const auto& [a, b, c] = mesh.triangles()[hit.triangle];
  const glm::vec3 normal = glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                      mesh.positions()[c] - mesh.positions()[a]);
  return glm::dot(normal, direction) > 0.0f;
}

}  // namespace

const model::Bvh& SightTrees::treeOf(const model::MeshPtr& mesh) {
  std::unique_ptr<model::Bvh>& tree = m_trees[mesh];
  if (!tree)
    tree = std::make_unique<model::Bvh>(mesh, model::spatialOrder(*mesh));
  return *tree;
}

void SightTrees::keepThoseOf(const model::Scene& scene) {
  std::set<model::MeshPtr> present;
  for (const model::Node& node : scene.nodes())
    present.insert(node.mesh);
  std::erase_if(m_trees, [&](const auto& entry) { return !present.contains(entry.first); });
}

Sights::Sights(const model::Scene& scene, SightTrees& trees) : m_scene(scene), m_trees(trees) {
  const std::array<model::NodeId, 1> all{model::rootId};
  for (const model::ResolvedStructure& structure : model::resolvedBelow(scene, all))
    if (structure.style.visible && structure.style.opacity.value() > 0.0f)
      m_bodies.push_back({structure.node, model::planesOf(scene.sectionsOf(structure.node->id)),
                          hidesWhatIsBehind(structure.style)});
}

const Sights::Body* Sights::find(model::NodeId id) const {
  const auto found = std::find_if(m_bodies.begin(), m_bodies.end(),
                                  [id](const Body& body) { return body.node->id == id; });
  return found == m_bodies.end() ? nullptr : &*found;
}

std::optional<Sights::Seen> Sights::meet(const Body& body, const model::Ray& ray) const {
  const model::Ray kept = keptPart(ray, body.planes);
  if (!(kept.nearest <= kept.farthest) || !reaches(kept, body.node->mesh->bounds()))
    return std::nullopt;
  std::optional<model::Hit> hit = m_trees.treeOf(body.node->mesh).nearest(kept);
  if (!hit)
    return std::nullopt;
  // A cut face has no triangles: a ray that enters at a section and sees the surface from within
  // came through one.
  const bool cutFace =
      kept.nearest > ray.nearest && seenFromWithin(*body.node->mesh, *hit, ray.direction);
  if (cutFace)
    hit->t = kept.nearest;
  return Seen{body.node->id, *hit, cutFace};
}

std::optional<Sights::Seen> Sights::nearest(const model::Ray& ray) const {
  std::optional<Seen> best;
  model::Ray rest = ray;
  for (const Body& body : m_bodies) {
    if (!body.hides)
      continue;
    if (const std::optional<Seen> seen = meet(body, rest)) {
      best = seen;
      rest.farthest = std::min(rest.farthest, seen->hit.t);
    }
  }
  return best;
}

bool Sights::drawnOver(model::NodeId structure, const model::Ray& ray) const {
  return std::any_of(m_bodies.begin(), m_bodies.end(), [&](const Body& body) {
    return body.node->id != structure && meet(body, ray);
  });
}

std::vector<model::MeshPtr> Sights::withoutTree() const {
  std::vector<model::MeshPtr> meshes;
  for (const Body& body : m_bodies)
    if (body.hides && !m_trees.has(body.node->mesh))
      meshes.push_back(body.node->mesh);
  return meshes;
}

std::optional<Sights::Seen> Sights::nearestOf(model::NodeId structure,
                                              const model::Ray& ray) const {
  const Body* body = find(structure);
  return body ? meet(*body, ray) : std::nullopt;
}

bool Sights::shows(const model::Anchor& anchor) const {
  const std::optional<glm::vec3> place = m_scene.placeOf(anchor);
  if (!place)
    return false;
  const auto* onSurface = std::get_if<model::SurfacePoint>(&anchor);
  if (!onSurface)
    return true;
  const Body* body = find(onSurface->structure);
  return body && model::keptByAll(body->planes, *place);
}

bool Sights::hidden(const model::Anchor& anchor, const model::Ray& ray) const {
  const glm::vec3 place = m_scene.placeOf(anchor).value_or(ray.origin);
  const float at = glm::dot(place - ray.origin, ray.direction);
  const auto* onSurface = std::get_if<model::SurfacePoint>(&anchor);
  for (const Body& body : m_bodies) {
    if (!body.hides)
      continue;
    const bool own = onSurface && onSurface->structure == body.node->id;
    const float size = glm::length(body.node->mesh->bounds().size());
    model::Ray before = ray;
    before.farthest = at - (own ? 0.005f * size : 1e-4f * size);
    if (before.nearest <= before.farthest && meet(body, before))
      return true;
  }
  return false;
}

}  // namespace sline::render
