// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/legend.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/anatomy/anatomical_names.h"
#include "model/scene/label_words.h"
#include "model/scene/visible_structures.h"

namespace sline::render {

namespace {

bool labelled(const model::Scene& scene, const model::Node& node) {
  const auto& annotations = scene.annotations();
  return std::any_of(annotations.begin(), annotations.end(), [&node](const auto& annotation) {
    const auto pointsAt = [&node](const model::Anchor& anchor) {
      const auto* point = std::get_if<model::SurfacePoint>(&anchor);
      return point && point->structure == node.id;
    };
    return annotation.visible &&
           std::any_of(annotation.anchors.begin(), annotation.anchors.end(), pointsAt);
  });
}

bool inFocus(const model::Scene& scene, const model::Node& node) {
  const auto& targets = scene.focus().targets;
  return std::any_of(targets.begin(), targets.end(), [&](model::NodeId target) {
    return target == node.id || scene.isBelow(node.id, target);
  });
}

std::string nameInOne(const std::string& name, const std::string& language) {
  static constexpr std::array<std::pair<std::string_view, model::NameLanguage>, 6> languages{
      {{"en", model::NameLanguage::english},
       {"de", model::NameLanguage::german},
       {"la", model::NameLanguage::latin},
       {"nb", model::NameLanguage::norwegian},
       {"no", model::NameLanguage::norwegian},
       {"nl", model::NameLanguage::dutch}}};
  static const model::AnatomicalNames names;
  const std::string primary = language.substr(0, language.find_first_of("-_"));
  const auto known = std::find_if(languages.begin(), languages.end(),
                                  [&](const auto& row) { return row.first == primary; });
  return known == languages.end() ? name : names.displayName(name, known->second);
}

}  // namespace

std::vector<const model::Node*> legendStructures(const model::Scene& scene, LegendList list) {
  std::vector<const model::Node*> listed;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    if (list == LegendList::all ||
        (list == LegendList::labelled && labelled(scene, *structure.node)) ||
        (list == LegendList::focus && inFocus(scene, *structure.node)))
      listed.push_back(structure.node);
  return listed;
}

std::string structureName(const std::string& name, const std::string& language) {
  std::string all;
  std::vector<std::string> said;
  for (const std::string& tag : model::languagesIn(language)) {
    const std::string one = nameInOne(name, tag);
    if (std::find(said.begin(), said.end(), one) != said.end())
      continue;
    all += (said.empty() ? "" : " / ") + one;
    said.push_back(one);
  }
  return all;
}

}  // namespace sline::render
