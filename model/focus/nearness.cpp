// SPDX-License-Identifier: Apache-2.0
#include "model/focus/nearness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "model/edit/locks.h"
#include "model/edit/visibility.h"
#include "model/geometry/sight.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/style_fields.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

/// Γ at the focus itself.
constexpr float nearGamma = 4.3f;
/// A structure that hides more than this share of the targets, or of what is near the place, is
/// drawn as an outline.
constexpr float muchOfTargets = 0.06f;
constexpr float muchOfPlace = 0.2f;
/// What is near a place is a disc of this part of the falloff.
constexpr float nearDisc = 0.3f;
constexpr std::size_t mostSamples = 64;

/// Returns the structures at or below the targets.
NodeSet nearTargets(const Scene& scene, std::span<const NodeId> targets) {
  NodeSet all;
  for (const NodeId id : scene.structuresBelow(targets))
    all.insert(id.value);
  return all;
}

/// Returns the points of a disc across the line of sight.
std::vector<glm::vec3> discAround(const glm::vec3& middle, float radius, const Camera& camera) {
  const CameraFrame frame = cameraFrame(camera);
  std::vector<glm::vec3> points{middle};
  constexpr float turn = 6.28318531f;
  for (const auto& [part, count] : {std::pair{0.5f, 8}, std::pair{1.0f, 16}})
    for (int i = 0; i < count; ++i) {
      const float angle = turn * float(i) / float(count);
      points.push_back(middle + part * radius *
                                    (std::cos(angle) * frame.right + std::sin(angle) * frame.up));
    }
  return points;
}

/// Returns points of the targets, evenly chosen among their vertices.
std::vector<glm::vec3> samplesOf(const Scene& scene, const NodeSet& targets) {
  std::size_t vertices = 0;
  for (const Node& node : scene.nodes())
    if (node.mesh && targets.contains(node.id.value))
      vertices += node.mesh->vertexCount();
  const std::size_t step = std::max<std::size_t>(1, vertices / mostSamples);
  std::vector<glm::vec3> points;
  std::size_t passed = 0;
  for (const Node& node : scene.nodes())
    if (node.mesh && targets.contains(node.id.value))
      for (const glm::vec3& p : node.mesh->positions())
        if (passed++ % step == 0)
          points.push_back(p);
  return points;
}

/// Returns the ray from the point to the eye.
Ray rayToEye(const Camera& camera, const glm::vec3& p) {
  Ray ray{.origin = p, .direction = towardsEye(camera, p)};
  if (camera.projection == Projection::perspective)
    ray.farthest = glm::distance(camera.eye, p);
  return ray;
}

Style nearTargetStyle() {
  Style style;
  style.visible = true;
  style.gamma = Gamma::clamped(nearGamma);
  style.fill = Fill::paper;
  style.opacity = Opacity::clamped(1.0f);
  style.penWeight = 1.0f;
  style.hatchTone = HatchTone::clamped(1.0f);
  style.gammaMap = GammaMap();
  return style;
}

Style nearOutlineStyle() {
  Style style;
  style.visible = true;
  style.gamma = Gamma::clamped(0.0f);
  style.fill = Fill::none;
  style.opacity = Opacity::clamped(1.0f);
  style.penWeight = 0.35f;
  style.gammaMap = GammaMap();
  return style;
}

Style distanceStyle(const NearFocus& focus) {
  Style style;
  style.visible = true;
  style.gamma = Gamma::clamped(0.0f);
  style.fill = Fill::paper;
  style.opacity = Opacity::clamped(1.0f);
  style.penWeight = 0.6f;
  style.hatchTone = HatchTone::clamped(1.0f);
  style.gammaMap = GammaMap{.scalar = GammaScalar::distance,
                            .targets = focus.nearness.place ? std::vector<NodeId>() : focus.targets,
                            .place = focus.nearness.place,
                            .curve = falloffCurve(focus.nearness.falloffMm)};
  return style;
}

/// Tells whether an earlier focus has faded the structure out, which is not the hand of a person.
bool fadedOutBefore(const Style& style) {
  return style.visible == false && style.opacity && style.opacity->value() <= 0.0f;
}

}  // namespace

float usualFalloffMm(const Scene& scene) {
  constexpr float share = 0.25f;
  const Box bounds = scene.visibleBounds();
  if (bounds.empty())
    return FocusNearness().falloffMm;
  return std::clamp(std::round(share * glm::length(bounds.size())), nearnessFalloffs.low,
                    nearnessFalloffs.high);
}

std::vector<GammaPoint> falloffCurve(float falloffMm) {
  return {{0.0f, nearGamma},
          {0.15f * falloffMm, nearGamma},
          {0.4f * falloffMm, 3.0f},
          {falloffMm, 0.0f}};
}

std::set<NodeId> structuresBefore(const Scene& scene, const NearFocus& focus, const Camera& camera,
                                  MeshTrees& trees) {
  const NodeSet targets = focus.nearness.place ? NodeSet() : nearTargets(scene, focus.targets);
  const std::vector<glm::vec3> points =
      focus.nearness.place
          ? discAround(*focus.nearness.place, nearDisc * focus.nearness.falloffMm, camera)
          : samplesOf(scene, targets);
  std::set<NodeId> before;
  for (const VisibleStructure& structure : visibleStructures(scene)) {
    const Node& node = *structure.node;
    if (targets.contains(node.id.value))
      continue;
    std::vector<Plane> planes;
    for (const Section& section : scene.sectionsOf(node.id))
      planes.push_back(section.plane);
    std::size_t hidden = 0;
    for (const glm::vec3& p : points) {
      const Ray ray = keptPart(rayToEye(camera, p), planes);
      if (ray.nearest <= ray.farthest && reaches(ray, node.mesh->bounds()))
        hidden += trees.of(node.mesh).blocked(ray) ? 1 : 0;
    }
    const float much = focus.nearness.place ? muchOfPlace : muchOfTargets;
    if (float(hidden) <= much * float(points.size()))
      continue;
    // What the place lies on is no obstacle, however it bulges around.
    const float touching = 1e-3f * glm::length(node.mesh->bounds().size());
    if (!focus.nearness.place ||
        !trees.of(node.mesh).isWithin(*focus.nearness.place, std::max(touching, 0.01f)))
      before.insert(node.id);
  }
  return before;
}

Edited withNearFocus(const Scene& scene, const NearFocus& focus, const std::set<NodeId>& before) {
  const NodeSet locked = lockedNodes(scene);
  const NodeSet targets = focus.nearness.place ? NodeSet() : nearTargets(scene, focus.targets);
  std::vector<NodeId> shown;
  for (const std::uint64_t id : targets)
    if (!locked.contains(id))
      shown.push_back(NodeId{id});
  Scene after = shown.empty() ? scene : withShown(scene, shown).scene;
  std::vector<Node> nodes = after.nodes();
  for (Node& node : nodes) {
    if (node.isGroup() || locked.contains(node.id.value))
      continue;
    const bool byHand = node.style.visible == false && !fadedOutBefore(node.style);
    if (byHand)
      continue;
    Style style = targets.contains(node.id.value) ? nearTargetStyle()
                  : before.contains(node.id)      ? nearOutlineStyle()
                                                  : distanceStyle(focus);
    patch(node.style, style);
  }
  after.setNodes(std::move(nodes));
  Focus said;
  said.targets = focus.nearness.place ? std::vector<NodeId>() : focus.targets;
  said.amount = scene.focus().amount;
  said.nearness = focus.nearness;
  said.unread = scene.focus().unread;
  after.setFocus(std::move(said));
  const bool changed = !(after == scene);
  return {std::move(after), changed};
}

Edited withoutNearness(const Scene& scene) {
  const auto focus = nearFocusOf(scene);
  if (!focus)
    return {scene, false};
  const GammaMap given = *distanceStyle(*focus).gammaMap;
  Scene after = scene;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (node.style.gammaMap &&
        (*node.style.gammaMap == given || *node.style.gammaMap == GammaMap()))
      node.style.gammaMap.reset();
  after.setNodes(std::move(nodes));
  Focus rest = scene.focus();
  rest.nearness.reset();
  after.setFocus(std::move(rest));
  return {std::move(after), true};
}

std::optional<NearFocus> nearFocusOf(const Scene& scene) {
  const Focus& focus = scene.focus();
  if (!focus.nearness)
    return std::nullopt;
  return NearFocus{.targets = focus.targets, .nearness = *focus.nearness};
}

}  // namespace sline::model
