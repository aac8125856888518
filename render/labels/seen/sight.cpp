// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/sight.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "model/geometry/sight.h"
#include "model/scene/resolved_styles.h"
#include "render/drawn/gamma_offsets.h"

namespace sline::render {

namespace {

bool isThin(const model::ResolvedStyle& style) {
  constexpr float thin = 0.4f;
  return style.opacity.value() < thin;
}

bool hidesWhatIsBehind(const model::ResolvedStyle& style) {
  constexpr float shaded = 3.5f;  // halfway from hatching to shading
  const bool filled = gammaSpan(style).most.value() >= shaded || style.fill == model::Fill::paper;
  return filled && !isThin(style);
}

}  // namespace

Sights::Sights(const model::Scene& scene, model::MeshTrees& trees)
    : m_scene(scene), m_trees(trees) {
  const std::array<model::NodeId, 1> all{model::rootId};
  for (const model::ResolvedStructure& structure : model::resolvedBelow(scene, all))
    if (structure.style.visible && structure.style.opacity.value() > 0.0f)
      m_bodies.push_back({structure.node, model::planesOf(scene.sectionsOf(structure.node->id)),
                          hidesWhatIsBehind(structure.style), !isThin(structure.style)});
}

const Sights::Body* Sights::find(model::NodeId id) const {
  const auto found = std::find_if(m_bodies.begin(), m_bodies.end(),
                                  [id](const Body& body) { return body.node->id == id; });
  return found == m_bodies.end() ? nullptr : &*found;
}

std::optional<Sights::SightHit> Sights::meet(const Body& body, const model::Ray& ray) const {
  if (!model::reaches(model::keptPart(ray, body.planes), body.node->mesh->bounds()))
    return std::nullopt;
  const std::optional<model::CutHit> met =
      model::nearestKept(m_trees.of(body.node->mesh), ray, body.planes);
  return met ? std::optional(SightHit{body.node->id, met->hit, met->cutFace}) : std::nullopt;
}

std::optional<Sights::SightHit> Sights::nearest(const model::Ray& ray) const {
  std::optional<SightHit> best;
  model::Ray rest = ray;
  for (const Body& body : m_bodies) {
    if (!body.hides)
      continue;
    if (const std::optional<SightHit> seen = meet(body, rest)) {
      best = seen;
      rest.farthest = std::min(rest.farthest, seen->hit.t);
    }
  }
  return best;
}

std::vector<model::MeshPtr> Sights::withoutTree() const {
  std::vector<model::MeshPtr> meshes;
  for (const Body& body : m_bodies)
    if (body.mayHide() && !m_trees.has(body.node->mesh))
      meshes.push_back(body.node->mesh);
  return meshes;
}

std::optional<Sights::SightHit> Sights::nearestOf(model::NodeId structure,
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
    if (!body.mayHide())
      continue;
    const bool own = onSurface && onSurface->structure == body.node->id;
    const float size = glm::length(body.node->mesh->bounds().size());
    const float before = at - (own ? 0.005f * size : 1e-4f * size);
    // The wall by which one knows a cut face may lie behind the place.
    const std::optional<SightHit> met = meet(body, ray);
    if (!met || met->hit.t > before)
      continue;
    if (body.hides || (met->cutFace && m_trees.solid(body.node->mesh)))
      return true;
  }
  return false;
}

}  // namespace sline::render
