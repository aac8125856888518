// SPDX-License-Identifier: Apache-2.0
#include "model/focus/kin.h"

#include <algorithm>
#include <array>
#include <map>

#include "model/anatomy/kin_names.h"

namespace sline::model {

namespace {

/// Returns the larger of two roles in the order in which they decide how kin is drawn: kin of which
/// one member hides the targets is a shell.
ContextRole stronger(ContextRole a, ContextRole b) {
  constexpr std::array order{ContextRole::target, ContextRole::shell, ContextRole::feeder,
                             ContextRole::neighbour, ContextRole::backdrop};
  return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b) ? a
                                                                                             : b;
}

void unite(std::span<Relation* const> kin) {
  Relation most = *kin.front();
  for (const Relation* each : kin) {
    if (stronger(each->role, most.role) == each->role && each->role != most.role) {
      most.role = each->role;
      most.reason = each->reason;
      most.through = each->through;
    }
    most.gapMm = std::min(most.gapMm, each->gapMm);
    most.gap = std::min(most.gap, each->gap);
    most.contact = std::max(most.contact, each->contact);
    most.feeding = std::max(most.feeding, each->feeding);
    most.nearness = std::max(most.nearness, each->nearness);
    most.hides = std::max(most.hides, each->hides);
    most.outside = std::min(most.outside, each->outside);
    most.size = std::max(most.size, each->size);
  }
  for (Relation* each : kin) {
    most.structure = each->structure;
    most.tissue = each->tissue;
    *each = most;
  }
}

float middleOf(const Node& node) {
  const Box box = node.mesh->bounds();
  return 0.5f * (box.low.x + box.high.x);
}

/// Returns whether the targets lie on the body's middle, which they do where no pair tells it.
bool onTheMiddle(const Scene& scene, std::span<const Relation> relations,
                 const std::map<std::string, std::array<const Node*, 2>>& pairs) {
  std::vector<float> middles;
  for (const auto& [name, pair] : pairs)
    if (pair[0] && pair[1])
      middles.push_back(0.5f * (middleOf(*pair[0]) + middleOf(*pair[1])));
  if (middles.empty())
    return true;
  const auto half = middles.begin() + std::ptrdiff_t(middles.size() / 2);
  std::nth_element(middles.begin(), half, middles.end());
  Box targets;
  for (const Relation& relation : relations)
    if (relation.role == ContextRole::target)
      targets.add(scene.find(relation.structure)->mesh->bounds());
  return targets.empty() || (targets.low.x < *half && *half < targets.high.x);
}

}  // namespace

void treatKinAlike(const Scene& scene, std::span<Relation> relations) {
  std::vector<KinName> names;
  std::map<std::string, std::array<const Node*, 2>> pairs;
  for (const Relation& relation : relations) {
    const Node* node = scene.find(relation.structure);
    names.push_back(kinName(node->name));
    if (names.back().side != Side::none)
      pairs[names.back().pair][names.back().side == Side::left ? 0 : 1] = node;
  }
  const bool middle = onTheMiddle(scene, relations, pairs);
  std::map<std::string, std::vector<Relation*>> kin;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    Relation& relation = relations[i];
    if (relation.role == ContextRole::target)
      continue;
    const bool family = (relation.tissue == Tissue::bone || relation.tissue == Tissue::joint) &&
                        !names[i].family.empty();
    if (!family && names[i].side == Side::none)
      continue;
    const std::string side = middle || names[i].side == Side::none ? ""
                             : names[i].side == Side::left         ? "l "
                                                                   : "r ";
    kin[side + (family ? names[i].family : names[i].pair)].push_back(&relation);
  }
  for (const auto& [name, members] : kin)
    unite(members);
}

}  // namespace sline::model
