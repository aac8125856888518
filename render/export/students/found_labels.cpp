// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/found_labels.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "model/anatomy/laterality_words.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/legend.h"
#include "render/labels/seen_map.h"

namespace sline::render {

namespace {

/// As many as have room beside a picture on a desk; telephones show those that have room there.
constexpr std::size_t mostSeen = 30;
constexpr glm::vec2 usualPageMm{160.0f, 90.0f};

/// Returns labels for the largest structures that one sees in the order's picture.
std::vector<model::Annotation> seenLabels(const ExportOrder& order) {
  const SeenMap map(order.scene, Screen(order.camera, usualPageMm));
  struct Candidate {
    model::Annotation label;
    float size = 0.0f;
  };
  std::vector<Candidate> all;
  for (const model::Node& node : order.scene.nodes()) {
    const std::optional<SeenPlace> place = node.isGroup() ? std::nullopt : map.find(node.id);
    // One asks of no sliver and no tangle what it is.
    if (!place || place->hidden || !place->sure)
      continue;
    Candidate& one = all.emplace_back();
    one.label = SeenMap::labelAt(node.id, *place);
    one.label.text = node.name;
    for (const std::string_view tag : model::nameLanguageTags)
      one.label.texts[std::string(tag)] = structureName(node.name, std::string(tag));
    one.size = glm::length(node.mesh->bounds().size());
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.size > b.size; });
  std::vector<model::Annotation> labels;
  for (std::size_t i = 0; i < std::min(all.size(), mostSeen); ++i)
    labels.push_back(std::move(all[i].label));
  return labels;
}

}  // namespace

model::Scene withFoundLabels(const ExportOrder& order) {
  model::Scene labelled = order.scene;
  if (!labelled.annotations().empty() || order.labels.mode == LabelMode::off)
    return labelled;
  std::map<model::NodeId, model::AnnotationId> there;
  const auto add = [&](const ExportOrder& seen, bool opening) {
    std::vector<model::AnnotationId> ids;
    for (model::Annotation& label : seenLabels(seen)) {
      const model::NodeId structure =
          std::get<model::SurfacePoint>(label.anchors.front()).structure;
      label.visible = opening;
      auto known = there.find(structure);
      if (known == there.end())
        known = there.emplace(structure, labelled.appendAnnotation(label)).first;
      ids.push_back(known->second);
    }
    return ids;
  };
  add(order, true);
  std::vector<model::View> views = order.scene.views();
  for (model::View& view : views)
    view.annotations = add(orderOfView(order, view), false);
  labelled.setViews(std::move(views));
  return labelled;
}

}  // namespace sline::render
