// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/found_labels.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "model/anatomy/laterality_words.h"
#include "model/scene/in_focus.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/legend.h"
#include "render/export/students/page_order.h"
#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {

/// As many as have room beside a still picture; the quiz asks for as many of each view.
constexpr std::size_t mostSeen = 30;

model::Annotation labelFor(const model::Node& node, const std::optional<SeenPlace>& place) {
  model::Annotation label;
  if (place)
    label = SeenMap::labelAt(node.id, *place);
  else
    label = {.anchors = {model::SurfacePoint{.structure = node.id}}, .text = {}, .found = true};
  label.text = node.name;
  for (const std::string_view tag : model::nameLanguageTags)
    label.texts[std::string(tag)] = structureName(node.name, std::string(tag));
  return label;
}

/// The structures of a scene: those in focus before others, the largest first.
std::vector<const model::Node*> structuresBySize(const model::Scene& scene) {
  std::vector<const model::Node*> all;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup() && node.mesh->triangleCount() > 0)
      all.push_back(&node);
  const auto rank = [&scene](const model::Node* node) {
    return std::pair(model::isInFocus(scene, node->id), glm::length(node->mesh->bounds().size()));
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const model::Node* a, const model::Node* b) { return rank(a) > rank(b); });
  return all;
}

/// Gives labels to what is seen in one picture after the other.
class LabelFinder {
 public:
  explicit LabelFinder(const model::Scene& scene) : m_structures(structuresBySize(scene)) {}

  /// Returns the largest structures that one sees in the order's picture, and finds their places.
  std::set<model::NodeId> look(const ExportOrder& order) {
    const SeenMap map(order.scene, Screen(order.camera, pagePictureMm)
                                       .onDark(order.environment.background == Background::dark));
    std::set<model::NodeId> seen;
    for (const model::Node* node : m_structures) {
      const std::optional<SeenPlace> place = map.find(node->id);
      // One asks of no sliver and no tangle what it is.
      if (!place || place->hidden || !place->sure)
        continue;
      m_places.emplace(node->id, *place);
      if (seen.size() < mostSeen)
        seen.insert(node->id);
    }
    return seen;
  }

  /// Adds the labels to the scene; those of the structures are visible.
  void label(model::Scene& scene, const std::set<model::NodeId>& visible) {
    for (const model::Node* node : m_structures) {
      const auto place = m_places.find(node->id);
      model::Annotation made =
          labelFor(*node, place == m_places.end() ? std::nullopt : std::optional(place->second));
      made.visible = visible.contains(node->id);
      m_ids[node->id] = scene.appendAnnotation(made);
    }
  }

  std::vector<model::AnnotationId> labelsOf(const std::set<model::NodeId>& structures) const {
    std::vector<model::AnnotationId> ids;
    for (const model::Node* node : m_structures)
      if (structures.contains(node->id))
        ids.push_back(m_ids.at(node->id));
    return ids;
  }

 private:
  std::vector<const model::Node*> m_structures;
  std::map<model::NodeId, SeenPlace> m_places;
  std::map<model::NodeId, model::AnnotationId> m_ids;
};

}  // namespace

model::Scene withFoundLabels(const ExportOrder& order) {
  model::Scene labelled = order.scene;
  if (!labelled.annotations().empty() || order.labels.mode == LabelMode::off)
    return labelled;
  LabelFinder finder(order.scene);
  const std::set<model::NodeId> opening = finder.look(order);
  std::vector<model::View> views = order.scene.views();
  std::vector<std::set<model::NodeId>> seen;
  seen.reserve(views.size());
  for (const model::View& view : views)
    seen.push_back(finder.look(orderOfView(order, view)));
  finder.label(labelled, opening);
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i].annotations = finder.labelsOf(seen[i]);
  labelled.setViews(std::move(views));
  return labelled;
}

model::Scene withAllLabels(const model::Scene& scene) {
  model::Scene all = scene;
  std::vector<model::Annotation> annotations = scene.annotations();
  for (model::Annotation& annotation : annotations)
    annotation.visible = true;
  all.setAnnotations(std::move(annotations));
  std::vector<model::View> views = scene.views();
  for (model::View& view : views)
    view.annotations.reset();
  all.setViews(std::move(views));
  return all;
}

}  // namespace sline::render
