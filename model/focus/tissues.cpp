// SPDX-License-Identifier: Apache-2.0
#include "model/focus/tissues.h"

#include <algorithm>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/cut_patterns.h"
#include "model/anatomy/name_words.h"

namespace sline::model {

Tissues tissuesOf(const Scene& scene) {
  static const AnatomyTable table;
  Tissues tissues;
  for (const Node& node : scene.nodes()) {
    const auto match = table.match(node.name);
    const auto above = tissues.find(node.parent.value);
    const Tissue inherited = above == tissues.end() ? Tissue::unknown : above->second;
    tissues[node.id.value] = match ? table.systems()[match->system].tissue : inherited;
  }
  return tissues;
}

namespace {

/// Tells whether the structure's name, else that of a group above it, says an organ with a wall
/// around a lumen; where none says anything, it may be one.
bool isHollow(const Scene& scene, const Node& node) {
  static const CutPatternTable table;
  for (const Node* at = &node; at; at = scene.find(at->parent))
    if (const auto pattern = table.match(at->name))
      return *pattern == CutPattern::wall;
  return true;
}

}  // namespace

bool mayBeDuct(const Scene& scene, const Node& node, Tissue tissue) {
  // Both the heart and the brain have ventricles, so that the word alone tells no tissue.
  const std::vector<std::string> words = nameWords(node.name);
  if (std::find(words.begin(), words.end(), "ventricle") != words.end() && tissue != Tissue::vessel)
    return false;
  switch (tissue) {
    case Tissue::unknown:
    case Tissue::vessel:
    case Tissue::nerve:
      return true;
    case Tissue::organ:
      return isHollow(scene, node);
    case Tissue::lesion:
    case Tissue::bone:
    case Tissue::joint:
    case Tissue::muscle:
    case Tissue::skin:
      break;
  }
  return false;
}

}  // namespace sline::model
