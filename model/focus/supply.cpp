// SPDX-License-Identifier: Apache-2.0
#include "model/focus/supply.h"

#include <algorithm>

#include "model/anatomy/vessel_supply.h"

namespace sline::model {

namespace {

struct Served {
  NodeId structure;
  bool target = false;
  VesselSupply::Name name;
};

void feed(Relation& relation, NodeId target) {
  constexpr float surely = 0.8f;
  if (relation.role != ContextRole::feeder) {
    relation.role = ContextRole::feeder;
    relation.reason = RoleReason::supplies;
    relation.through = target;
  }
  relation.feeding = std::max(relation.feeding, surely);
}

void passBy(Relation& relation) {
  const bool near = relation.nearness >= 0.5f;
  relation.role = near ? ContextRole::neighbour : ContextRole::backdrop;
  relation.reason = near ? RoleReason::near : RoleReason::far;
  relation.feeding = 0.0f;
}

}  // namespace

void treatVesselsByWhatTheyFeed(const Scene& scene, std::span<Relation> relations) {
  static const VesselSupply supply;
  std::vector<Served> served;
  for (const Relation& relation : relations)
    if (relation.tissue != Tissue::vessel)
      served.push_back({relation.structure, relation.role == ContextRole::target,
                        supply.understood(scene.find(relation.structure)->name)});
  for (Relation& relation : relations) {
    if (relation.tissue != Tissue::vessel || relation.role == ContextRole::target)
      continue;
    const auto name = supply.understood(scene.find(relation.structure)->name);
    const Served* other = nullptr;
    const Served* target = nullptr;
    for (const Served& each : served)
      if (supply.serves(name, each.name))
        (each.target ? target : other) = &each;
    if (target)
      feed(relation, target->structure);
    else if (other && relation.reason == RoleReason::reaches)
      passBy(relation);
  }
}

}  // namespace sline::model
