// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/legend.h"

#include <algorithm>

#include "model/anatomy/anatomical_names.h"
#include "model/scene/in_focus.h"
#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "model/scene/visible_structures.h"
#include "render/lettering/label_texts.h"

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
    if ((list == LegendList::all ||
         (list == LegendList::labelled && labelled.contains(structure.node->id.value)) ||
         (list == LegendList::focus && model::isInFocus(scene, structure.node->id))) &&
        !isCutAway(scene, *structure.node))
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

std::string structureName(const model::Node& node, const std::string& language) {
  std::string name = structureName(node.name, language);
  if (model::isNameDoubted(node))
    name += model::doubtMark;
  return name;
}

std::string distanceEnds(const model::Scene& scene, const model::Annotation& annotation,
                         const std::string& language) {
  std::vector<std::string> names;
  for (const model::Anchor& anchor : annotation.anchors) {
    const auto* point = std::get_if<model::SurfacePoint>(&anchor);
    const model::Node* node = point ? scene.find(point->structure) : nullptr;
    if (!node || annotation.kind != model::AnnotationKind::distance)
      continue;
    std::string name = structureName(*node, language);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  }
  std::string ends;
  for (const std::string& name : names)
    ends += (ends.empty() ? "" : " – ") + name;
  return ends;
}

std::string keyLine(const model::Scene& scene, const ShownLabel& label, const LabelStyle& style) {
  std::string ends;
  if (label.length && label.text.empty())
    for (const model::Annotation& annotation : scene.annotations())
      if (annotation.id == label.item.id)
        ends = distanceEnds(scene, annotation, model::firstLanguage(style.language));
  return (ends.empty() ? "" : ends + ": ") + keyText(label, style);
}

}  // namespace sline::render
