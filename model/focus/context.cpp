// SPDX-License-Identifier: Apache-2.0
#include "model/focus/context.h"

#include <algorithm>
#include <glm/common.hpp>
#include <unordered_map>
#include <unordered_set>

#include "model/edit/node_sets.h"
#include "model/edit/visibility.h"
#include "model/focus/nearness.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

constexpr float focusGamma = 4.3f;
/// The amount by which every structure of a known tissue begins to appear.
constexpr float latestStart = 0.45f;
/// And what nobody knows from here on, so that the amount with which plates open draws all of it: a
/// look that is chosen for a scene leaves out nothing that is in it.
constexpr float latestUnknown = 0.55f;
/// The amount from which structures of a known tissue have their wash. Below Γ = 4 what faces the
/// eye is as white as paper, as if the structure were hollow.
constexpr float washed = 0.7f;
/// The pen of structures that are faded out; it is thin in case the user shows them by hand.
constexpr float faintPen = 0.4f;

/// Describes how structures of one kind grow with the amount.
struct Growth {
  float start = 0.0f;  ///< the amount at which it begins to appear
  float full = 1.0f;   ///< the amount from which its Γ stays constant
  float lowGamma = 0.0f;
  float highGamma = 0.0f;
  float lowPen = 0.0f;  ///< factor on the scene's pen
  float highPen = 1.0f;
  float covering = 0.0f;  ///< how much it hides of what lies behind it
  float tone = 1.0f;      ///< factor on the darkness of hatching
};

float ramp(float low, float high, float x) {
  return std::clamp((x - low) / (high - low), 0.0f, 1.0f);
}

/// Returns how clear of the targets a structure is: filled and in front of them it would hide them.
float clearness(const Relation& r) {
  return 1.0f - glm::smoothstep(0.05f, 0.5f, r.hides);
}

Growth feederGrowth(const Relation& r) {
  // Vessels that come to a target appear first, then the stems from which they come.
  const float less = 1.0f - std::clamp(r.feeding, 0.5f, 1.0f);
  return {.start = 0.02f + 0.2f * less,
          .full = 0.6f,
          .lowGamma = 1.2f,
          .highGamma = 4.2f - less,
          .lowPen = 0.8f,
          .highPen = 1.0f,
          .covering = 0.6f + 0.4f * clearness(r)};
}

Growth neighbourGrowth(const Relation& r) {
  return {.start = 0.06f + 0.7f * glm::smoothstep(0.05f, 0.6f, r.gap),
          .full = 1.0f,
          .lowGamma = 0.6f,
          .highGamma = glm::mix(2.4f, 1.2f, r.hides),
          .lowPen = 0.3f,
          .highPen = 0.85f,
          .covering = 0.2f + 0.7f * clearness(r)};
}

Growth shellGrowth(const Relation& r) {
  // The structures that hide most show best where everything is.
  return {.start = 0.3f + 0.35f * (1.0f - r.hides),
          .full = 1.0f,
          .lowGamma = 0.0f,
          .highGamma = 1.0f,
          .lowPen = 0.3f,
          .highPen = 0.55f};
}

Growth backdropGrowth(const Relation& r) {
  const float far = glm::smoothstep(0.3f, 4.0f, r.gap);
  return {.start = 0.5f + 0.3f * far,
          .full = 1.0f,
          .lowGamma = 0.0f,
          .highGamma = 1.4f,
          .lowPen = 0.25f,
          .highPen = 0.55f,
          .covering = 0.1f + 0.7f * clearness(r)};
}

/// Returns how a structure before the focus grows: as a thin silhouette, so that none of its lines
/// crosses the focus (METHOD §12.4).
Growth frontGrowth(Growth growth) {
  growth.lowGamma = 0.0f;
  growth.highGamma = 0.2f;
  growth.lowPen = 0.3f;
  growth.highPen = 0.5f;
  growth.covering = 0.0f;
  growth.start = std::min(growth.start, latestStart);
  return growth;
}

bool isNear(const Relation& r) {
  return r.nearness >= 0.5f;
}

/// Returns how a structure beside or behind the focus grows that is made of that tissue: pale and
/// quiet, bones modelled a little more (METHOD §12.5).
Growth tissueGrowth(Growth growth, const Relation& r) {
  const bool near = isNear(r);
  switch (r.tissue) {
    case Tissue::unknown:
    case Tissue::lesion:
      return growth;
    case Tissue::bone:
    case Tissue::joint:
      growth.lowGamma = 3.3f;
      growth.highGamma = near ? 4.0f : 3.9f;
      break;
    case Tissue::vessel:
    case Tissue::nerve:
      growth.lowGamma = 3.2f;
      growth.highGamma = near ? 4.2f : 4.1f;
      break;
    case Tissue::organ:
    case Tissue::muscle:
    case Tissue::skin:
      growth.lowGamma = 3.2f;
      growth.highGamma = near ? 4.1f : 4.05f;
      break;
  }
  growth.full = washed;
  growth.tone = 0.0f;
  growth.covering = 1.0f;
  growth.start = std::min(growth.start, latestStart);
  return growth;
}

/// Tells whether the targets lie in a structure that is open towards the eye, as a ligand lies in
/// the pocket of its protein.
bool isHost(const Relation& r) {
  constexpr float embedded = 0.5f;
  constexpr float mostHidden = 0.6f;
  return r.tissue == Tissue::unknown && r.contact >= embedded && r.hides <= mostHidden;
}

/// Returns how a host grows: as a solid of thin outlines and a glaze at its rims, pale enough not
/// to compete with the targets; what lies in its depth stays out of the picture.
Growth hostGrowth() {
  return {.start = 0.05f,
          .full = 0.7f,
          .lowGamma = 3.0f,
          .highGamma = 3.5f,
          .lowPen = 0.3f,
          .highPen = 0.7f,
          .covering = 1.0f,
          .tone = 0.0f};
}

Growth roleGrowth(const Relation& r) {
  switch (r.role) {
    case ContextRole::feeder:
      return feederGrowth(r);
    case ContextRole::neighbour:
      return neighbourGrowth(r);
    case ContextRole::shell:
      return shellGrowth(r);
    case ContextRole::target:
    case ContextRole::backdrop:
      break;
  }
  return backdropGrowth(r);
}

Growth growthOf(const Relation& r) {
  switch (mannerOf(r)) {
    case ContextManner::host:
      return hostGrowth();
    case ContextManner::outline:
      return frontGrowth(roleGrowth(r));
    case ContextManner::near:
    case ContextManner::far:
      return tissueGrowth(roleGrowth(r), r);
    case ContextManner::detail:
    case ContextManner::feeder:
    case ContextManner::byRole:
      break;
  }
  Growth growth = roleGrowth(r);
  growth.start = std::min(growth.start, latestUnknown);
  return growth;
}

Style targetStyle() {
  Style style;
  style.visible = true;
  style.gamma = Gamma::clamped(focusGamma);
  style.fill = Fill::paper;
  style.opacity = Opacity::clamped(1.0f);
  style.penWeight = 1.0f;
  style.hatchTone = HatchTone::clamped(1.0f);
  return style;
}

Fill fillOf(const Relation& r, const Growth& growth) {
  constexpr float nothing = 0.1f;
  if (growth.covering <= 0.0f)
    return Fill::none;
  return r.hides <= nothing || isHost(r) ? Fill::paper : Fill::veil;
}

}  // namespace

bool looksInFocus(const ResolvedStyle& style) {
  return style.gamma == Gamma::clamped(focusGamma);
}

ContextManner mannerOf(const Relation& r) {
  if (r.role == ContextRole::target)
    return ContextManner::detail;
  if (isHost(r))
    return ContextManner::host;
  if (r.tissue == Tissue::unknown)
    return ContextManner::byRole;
  constexpr float something = 0.05f;
  if (r.role == ContextRole::shell || r.hides > (r.role == ContextRole::feeder ? 0.3f : something))
    return ContextManner::outline;
  if (r.role == ContextRole::feeder)
    return ContextManner::feeder;
  if (r.tissue == Tissue::lesion)
    return ContextManner::byRole;
  return isNear(r) ? ContextManner::near : ContextManner::far;
}

Style contextStyle(const Relation& relation, ContextAmount amount) {
  if (relation.role == ContextRole::target)
    return targetStyle();
  constexpr float entrance = 0.15f;
  const Growth growth = growthOf(relation);
  const float x = amount.value();
  const float there = ramp(growth.start, growth.start + entrance, x);
  Style style;
  style.visible = there > 0.0f;
  style.gamma = Gamma::clamped(
      glm::mix(growth.lowGamma, growth.highGamma, ramp(growth.start, growth.full, x)));
  style.fill = fillOf(relation, growth);
  style.opacity = Opacity::clamped(*style.fill == Fill::none ? there : there * growth.covering);
  style.penWeight = there * glm::mix(growth.lowPen, growth.highPen, x * x);
  if (!*style.visible)
    style.penWeight = faintPen;
  style.hatchTone = HatchTone::clamped(growth.tone);
  return style;
}

namespace {

/// Says whether a structure may be drawn differently.
struct Standing {
  bool locked = false;        ///< true if it or a group above it is locked
  bool hiddenByHand = false;  ///< true if it or a group above it is hidden by hand
};

/// Tells whether the focus hid a structure: it fades out to zero opacity, while users hide
/// structures as they are.
bool fadedOut(const Style& style) {
  return style.visible == false && style.opacity && style.opacity->value() <= 0.0f;
}

/// Returns the standings of all nodes, in one pass because a parent stands before its children.
std::unordered_map<std::uint64_t, Standing> standings(const Scene& scene) {
  std::unordered_map<std::uint64_t, Standing> standings;
  for (const Node& node : scene.nodes()) {
    Standing standing = standings[node.parent.value];
    standing.locked = standing.locked || node.locked;
    if (node.style.visible == false && !fadedOut(node.style))
      standing.hiddenByHand = true;
    standings[node.id.value] = standing;
  }
  return standings;
}

/// Returns those of the structures set by hand that stay so: a person who puts a structure in focus
/// wants it as a target, whatever she made of it while it was context.
std::unordered_set<std::uint64_t> keptByHand(const Scene& scene, const FocusAnalysis& analysis) {
  std::unordered_set<std::uint64_t> kept = setOf(setByHand(scene));
  const std::unordered_set<std::uint64_t> before =
      setOf(scene.structuresBelow(scene.focus().targets));
  for (const NodeId id : analysis.targets) {
    const Node* node = scene.find(id);
    if (!before.contains(id.value) || !node || node->style.visible == false)
      kept.erase(id.value);
  }
  return kept;
}

/// Returns the focus that the scene has with these styles.
Focus focusOf(const Scene& scene, const FocusAnalysis& analysis,
              const std::unordered_map<std::uint64_t, Style>& given) {
  Focus focus = scene.focus();
  focus.targets = analysis.asked;
  focus.seenFrom = analysis.camera;
  focus.given.clear();
  for (const Relation& relation : analysis.relations)
    if (const auto style = given.find(relation.structure.value); style != given.end())
      focus.given.push_back({.node = relation.structure, .style = style->second});
  return focus;
}

}  // namespace

std::vector<NodeId> setByHand(const Scene& scene) {
  std::vector<NodeId> changed;
  bool asGiven = false;
  for (const Look& look : scene.focus().given) {
    const Node* node = scene.find(look.node);
    if (!node)
      continue;
    if (picked(node->style, look.style) != look.style)
      changed.push_back(look.node);
    else
      asGiven = asGiven || look.style.visible == true;
  }
  return asGiven || changed.size() == 1 ? changed : std::vector<NodeId>();
}

Edited withoutHand(const Scene& scene, std::span<const NodeId> ids) {
  const std::unordered_set<std::uint64_t> wanted = setOf(ids);
  std::unordered_map<std::uint64_t, const Style*> styles;
  for (const Look& look : scene.focus().given)
    if (wanted.contains(look.node.value))
      styles[look.node.value] = &look.style;
  Scene after = scene;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (const auto style = styles.find(node.id.value); style != styles.end())
      patch(node.style, *style->second);
  after.setNodes(std::move(nodes));
  const bool changed = !(after == scene);
  return {std::move(after), changed};
}

std::vector<NodeId> hiddenByHand(const Scene& scene, const FocusAnalysis& analysis) {
  const auto all = standings(scene);
  std::vector<NodeId> hidden;
  for (const Relation& relation : analysis.relations) {
    const auto standing = all.find(relation.structure.value);
    if (standing != all.end() && standing->second.hiddenByHand && !standing->second.locked &&
        relation.role != ContextRole::target)
      hidden.push_back(relation.structure);
  }
  return hidden;
}

Edited withFocusAndContext(const Scene& before, const FocusAnalysis& analysis, ContextAmount amount,
                           const ContextWishes& wishes) {
  const Scene scene = withoutNearness(before).scene;
  const auto all = standings(scene);
  const std::unordered_set<std::uint64_t> hers = keptByHand(scene, analysis);
  std::vector<NodeId> opened;
  std::unordered_map<std::uint64_t, Style> given;
  std::unordered_map<std::uint64_t, Style> styles;
  for (Relation relation : analysis.relations) {
    const auto standing = all.find(relation.structure.value);
    if (standing == all.end() || standing->second.locked)
      continue;
    if (const auto wish = wishes.roles.find(relation.structure); wish != wishes.roles.end())
      relation.role = wish->second;
    const bool hidden = standing->second.hiddenByHand;
    const Style& style = given[relation.structure.value] = contextStyle(relation, amount);
    if (hers.contains(relation.structure.value) && !(hidden && wishes.hiddenToo))
      continue;
    if (hidden && relation.role != ContextRole::target && !wishes.hiddenToo)
      continue;
    if (hidden)
      opened.push_back(relation.structure);
    styles[relation.structure.value] = style;
  }
  Scene after = withShown(scene, opened).scene;
  std::vector<Node> nodes = after.nodes();
  for (Node& node : nodes)
    if (const auto style = styles.find(node.id.value); style != styles.end())
      patch(node.style, style->second);
  after.setNodes(std::move(nodes));
  Focus focus = focusOf(scene, analysis, given);
  focus.amount = amount;
  focus.wishes = wishes;
  after.setFocus(std::move(focus));
  const bool changed = !(after == before);
  return {std::move(after), changed};
}

}  // namespace sline::model
