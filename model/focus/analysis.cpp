// SPDX-License-Identifier: Apache-2.0
#include "model/focus/analysis.h"

#include <algorithm>
#include <cmath>

#include "model/base/parallel.h"
#include "model/focus/kin.h"
#include "model/focus/roles.h"
#include "model/focus/supply.h"
#include "model/focus/surroundings.h"
#include "model/focus/tissues.h"

namespace sline::model {

std::optional<FocusAnalysis> analysed(const Scene& scene, const FocusQuestion& question,
                                      FormIndex& forms, const std::stop_token& stop) {
  FocusAnalysis analysis;
  analysis.targets = scene.structuresBelow(question.targets);
  analysis.asked.assign(question.targets.begin(), question.targets.end());
  analysis.camera = question.camera;
  const Tissues tissues = tissuesOf(scene);
  std::vector<Party> parties;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      parties.push_back({.id = node.id,
                         .mesh = node.mesh,
                         .planes = planesOf(scene.sectionsOf(node.id)),
                         .target = std::find(analysis.targets.begin(), analysis.targets.end(),
                                             node.id) != analysis.targets.end(),
                         .form = {},
                         .mayFeed = mayBeDuct(scene, node, tissues.at(node.id.value))});
  parallelFor(parties.size(), 1, [&](std::size_t i) {
    if (!stop.stop_requested())
      parties[i].form = forms.of(parties[i].mesh);
  });
  if (stop.stop_requested())
    return std::nullopt;
  std::vector<Camera> cameras(question.turn.begin(), question.turn.end());
  if (cameras.empty() && question.camera)
    cameras.push_back(*question.camera);
  const Surroundings surroundings(parties, cameras);
  if (!surroundings.answerable())
    return std::nullopt;
  std::vector<Facts> facts(parties.size());
  parallelFor(parties.size(), 1, [&](std::size_t i) {
    if (!stop.stop_requested())
      facts[i] = surroundings.factsOf(parties[i]);
  });
  const std::vector<Feeding> fed = feedings(surroundings, parties, facts, stop);
  if (stop.stop_requested())
    return std::nullopt;
  for (std::size_t i = 0; i < parties.size(); ++i)
    analysis.relations.push_back(relationOf(surroundings, parties[i], facts[i], fed[i]));
  for (Relation& relation : analysis.relations)
    relation.tissue = tissues.at(relation.structure.value);
  treatVesselsByWhatTheyFeed(scene, analysis.relations);
  treatKinAlike(scene, analysis.relations);
  return analysis;
}

}  // namespace sline::model
