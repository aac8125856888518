// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/legend.h"

#include <algorithm>

#include "model/anatomy/anatomical_names.h"
#include "model/scene/in_focus.h"
#include "model/scene/label_words.h"
#include "model/scene/visible_structures.h"

namespace sline::render {

namespace {

std::string nameInOne(const std::string& name, const std::string& language) {
  static const model::AnatomicalNames names;
  const auto known = model::nameLanguageOf(language);
  return known ? names.displayName(name, *known) : name;
}

}  // namespace

std::vector<const model::Node*> legendStructures(const model::Scene& scene, LegendList list) {
  const auto labelled = model::annotatedStructures(scene);
  std::vector<const model::Node*> listed;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    if (list == LegendList::all ||
        (list == LegendList::labelled && labelled.contains(structure.node->id.value)) ||
        (list == LegendList::focus && model::isInFocus(scene, structure.node->id)))
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
