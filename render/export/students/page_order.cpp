// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_order.h"

#include <algorithm>

#include "model/edit/views.h"
#include "model/scene/in_focus.h"
#include "model/scene/known_frame.h"
#include "model/scene/visible_structures.h"
#include "render/export/students/found_labels.h"

namespace sline::render {

namespace {

/// Holds what is shown at some time.
struct Shown {
  std::set<model::NodeId> nodes;  ///< with the groups above them
  std::set<model::AnnotationId> annotations;
};

void addShown(Shown& shown, const model::Scene& scene) {
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    for (const model::Node* node = structure.node; node; node = scene.find(node->parent))
      shown.nodes.insert(node->id);
  for (const model::Annotation& annotation : scene.annotations())
    if (annotation.visible)
      shown.annotations.insert(annotation.id);
}

bool isOn(const model::Annotation& annotation, const std::set<model::NodeId>& nodes) {
  return std::all_of(annotation.anchors.begin(), annotation.anchors.end(),
                     [&nodes](const model::Anchor& anchor) {
                       const auto* point = std::get_if<model::SurfacePoint>(&anchor);
                       return !point || nodes.contains(point->structure);
                     });
}

/// Returns the node without anything that nobody sees; `unit` is that of the whole scene.
model::Node published(model::Node node, model::DrawnUnit unit) {
  model::Provenance kept;
  // These say how smooth the surface is drawn.
  kept.smoothingSteps = node.provenance.smoothingSteps;
  kept.refinementSteps = node.provenance.refinementSteps;
  kept.sliceMm = node.provenance.sliceMm;
  // How far import has moved it decides how distances from it are told.
  kept.displacementMm = node.provenance.displacementMm;
  kept.decimatedFrom = node.provenance.decimatedFrom;
  kept.decimationMm = node.provenance.decimationMm;
  kept.credit = node.provenance.credit;
  // And these what its coordinates stand for: never words of a file.
  if (node.provenance.frame == model::fileFrame)
    kept.frame = model::fileFrame;
  kept.evidence = node.provenance.evidence;
  if (unit == model::DrawnUnit::angstrom && node.provenance.unitReason == model::angstromReason)
    kept.unitReason = model::angstromReason;
  kept.nameEvidence = node.provenance.nameEvidence;
  kept.unitEvidence = node.provenance.unitEvidence;
  node.provenance = kept;
  node.atoms = {};
  node.drawn.reset();
  node.unread.clear();
  return node;
}

void keepNodes(std::vector<model::NodeId>& ids, const std::set<model::NodeId>& kept) {
  std::erase_if(ids, [&kept](model::NodeId id) { return !kept.contains(id); });
}

void keepLooks(std::vector<model::Look>& looks, const std::set<model::NodeId>& kept) {
  std::erase_if(looks, [&kept](const model::Look& look) { return !kept.contains(look.node); });
}

model::Focus published(model::Focus focus, const std::set<model::NodeId>& kept) {
  keepNodes(focus.targets, kept);
  keepLooks(focus.given, kept);
  std::erase_if(focus.wishes.roles,
                [&kept](const auto& role) { return !kept.contains(role.first); });
  focus.unread.clear();
  return focus;
}

std::vector<model::Section> published(std::vector<model::Section> sections,
                                      const std::set<model::NodeId>& kept) {
  std::erase_if(sections, [&kept](const model::Section& section) {
    return section.scope != model::rootId && !kept.contains(section.scope);
  });
  for (std::size_t i = 0; i < sections.size(); ++i) {
    sections[i].name = std::to_string(i + 1);
    sections[i].unread.clear();
  }
  return sections;
}

model::View published(model::View view, const Shown& shown) {
  view.words.notes = {};
  view.unread.clear();
  if (view.sections)
    view.sections = published(*view.sections, shown.nodes);
  if (view.looks)
    keepLooks(*view.looks, shown.nodes);
  if (view.annotations)
    std::erase_if(*view.annotations,
                  [&shown](model::AnnotationId id) { return !shown.annotations.contains(id); });
  if (view.focus)
    view.focus = published(*view.focus, shown.nodes);
  return view;
}

}  // namespace

ExportOrder pageOrder(const ExportOrder& order) {
  const model::Scene& scene = order.scene;
  Shown shown;
  addShown(shown, scene);
  for (const model::View& view : scene.views())
    addShown(shown, model::withViewApplied(scene, view).scene);
  std::vector<model::Node> nodes;
  const model::DrawnUnit unit = drawnUnit(scene);
  for (const model::Node& node : scene.nodes())
    if (shown.nodes.contains(node.id))
      nodes.push_back(published(node, unit));
  std::vector<model::Annotation> annotations;
  for (model::Annotation annotation : scene.annotations())
    if (shown.annotations.contains(annotation.id) && isOn(annotation, shown.nodes)) {
      annotation.unread.clear();
      annotations.push_back(std::move(annotation));
    } else {
      shown.annotations.erase(annotation.id);
    }
  ExportOrder page = order;
  page.scene.setAnnotations({});
  page.scene.setNodes(std::move(nodes));
  page.scene.setAnnotations(std::move(annotations));
  page.scene.setSections(published(scene.sections(), shown.nodes));
  page.scene.setFocus(published(scene.focus(), shown.nodes));
  page.scene.setScans({});
  page.scene.setUnread({});
  std::vector<model::View> views;
  for (const model::View& view : scene.views())
    views.push_back(published(view, shown));
  if (views.empty()) {
    views.push_back(model::viewOf(page.scene, order.camera, order.viewName));
    views.back().words = order.words;
    views.back().words.notes = {};
  }
  page.scene.setViews(std::move(views));
  const bool labelled = !page.scene.annotations().empty();
  page.scene = withFoundLabels(page);
  page.of<StudentsOptions>().foundLabels = !labelled && !page.scene.annotations().empty();
  return page;
}

std::set<model::NodeId> laterStructures(const model::Scene& scene) {
  std::set<model::NodeId> later;
  bool focus = false;
  for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
    const bool inFocus = model::isInFocus(scene, id);
    focus = focus || (inFocus && scene.resolve(id).visible);
    if (!inFocus)
      later.insert(id);
  }
  return focus ? later : std::set<model::NodeId>();
}

std::size_t trianglesOf(const model::Scene& scene) {
  std::size_t triangles = 0;
  for (const model::MeshPtr& mesh : model::meshesOf(scene))
    triangles += mesh->triangleCount();
  return triangles;
}

}  // namespace sline::render
