// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_figure.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/anatomy/laterality_words.h"
#include "model/scene/in_focus.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

namespace {

constexpr float patientLabels = 12.0f;  // points

constexpr std::size_t mostLabels = 36;
constexpr std::size_t mostPatientLabels = 10;

/// Describes a structure that has no label yet.
struct Candidate {
  model::Annotation label;
  float x = 0.0f;     ///< that of its place, from the picture's middle
  float size = 0.0f;  ///< that of the structure
  glm::vec3 centre{0.0f};
  bool focus = false;  ///< the structure is in focus: it is labelled before others
  model::Side side = model::Side::none;
  std::string otherwise;  ///< its name without the side
};

std::vector<Candidate> candidates(const ExportOrder& order) {
  const Screen screen = pageScreen(order);
  const model::Scene scene = withLooksInColour(order.scene, order.labels.inColour);
  const SeenMap map(scene, screen);
  std::vector<Candidate> all;
  for (const model::Node& node : order.scene.nodes()) {
    if (node.isGroup())
      continue;
    const std::optional<SeenPlace> place = map.find(node.id);
    // One asks of no sliver and no tangle what it is.
    if (!place || place->hidden || !place->sure)
      continue;
    Candidate one;
    one.label = SeenMap::labelAt(node.id, *place);
    one.label.text = structureName(node.name, order.labels.language);
    one.x = place->place.x - 0.5f * order.page.sizeMm.x;
    one.size = glm::length(node.mesh->bounds().size());
    one.centre = node.mesh->bounds().centre();
    one.focus = model::isInFocus(order.scene, node.id);
    for (const std::string& word : model::wordsOf(node.name)) {
      const model::Side side = model::sideOfWord(word);
      if (side == model::Side::none)
        one.otherwise += word + ' ';
      else
        one.side = side;
    }
    if (!one.label.text.empty())
      all.push_back(std::move(one));
  }
  return all;
}

/// Tells whether the two are each other's mirror image, so that one name is enough for both: they
/// lie beside each other and are of a size. The ventricles of the heart are not.
bool areMirrorImages(const Candidate& one, const Candidate& other) {
  constexpr float aslant = 0.35f;  // of how far they are apart from side to side
  constexpr float larger = 1.5f;
  const glm::vec3 way = glm::abs(one.centre - other.centre);
  return glm::length(glm::vec2(way.y, way.z)) < aslant * way.x && one.size < larger * other.size &&
         other.size < larger * one.size;
}

/// Keeps one of each left and right pair of mirror images: the one that fills both sides of the
/// picture evenly.
std::vector<Candidate> oneOfEachPair(const std::vector<Candidate>& all) {
  const auto partner = [&all](const Candidate& one) -> const Candidate* {
    const auto found = std::find_if(all.begin(), all.end(), [&one](const Candidate& other) {
      return one.side != model::Side::none && other.side != model::Side::none &&
             other.side != one.side && other.otherwise == one.otherwise &&
             areMirrorImages(one, other);
    });
    return found == all.end() ? nullptr : &*found;
  };
  std::vector<Candidate> chosen;
  int balance = 0;  // how many more stand on the right of the picture
  const auto choose = [&](const Candidate& one) {
    chosen.push_back(one);
    balance += one.x < 0.0f ? -1 : 1;
  };
  for (const Candidate& one : all)
    if (!partner(one))
      choose(one);
  for (const Candidate& one : all)
    if (const Candidate* other = partner(one); other && &one < other)
      choose((one.x < other->x) == (balance > 0) ? one : *other);
  return chosen;
}

/// Returns the scene with labels for structures that are seen and have room for one, the large ones
/// first.
model::Scene labelled(const ExportOrder& order) {
  const bool patient = order.of<SheetOptions>().kind == SheetKind::patient;
  ExportOrder figure = order;
  if (!patient)
    figure.labels.mode = LabelMode::numbers;
  std::vector<model::Annotation> labels;
  std::vector<Candidate> chosen = oneOfEachPair(candidates(order));
  std::stable_sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) {
    return std::pair(a.focus, a.size) > std::pair(b.focus, b.size);
  });
  const std::size_t most = patient ? mostPatientLabels : mostLabels;
  for (std::size_t i = 0; i < std::min(most, chosen.size()); ++i)
    labels.push_back(chosen[i].label);
  model::MeshTrees trees;
  for (int round = 0; round < 4; ++round) {
    figure.scene = order.scene;
    for (const model::Annotation& label : labels)
      figure.scene.appendAnnotation(label);
    const FigurePlate plate = figurePlate(figure, trees);
    std::vector<std::pair<LabelBox, model::Annotation>> placed;
    for (const PlacedLabel& one : plate.labels->layout.labels)
      for (const model::Annotation& label : figure.scene.annotations())
        if (label.id == one.id)
          placed.emplace_back(one.box, label);
    const float middle = 0.5f * order.page.sizeMm.x;
    std::stable_sort(placed.begin(), placed.end(), [middle](const auto& a, const auto& b) {
      const bool left = a.first.middle().x < middle;
      return left == (b.first.middle().x < middle) ? a.first.low.y < b.first.low.y : left;
    });
    const bool settled = round > 0 && placed.size() == labels.size();
    labels.clear();
    for (const auto& [box, label] : placed)
      labels.push_back(label);
    if (settled)
      break;
  }
  model::Scene scene = order.scene;
  for (const model::Annotation& label : labels)
    scene.appendAnnotation(label);
  return scene;
}

}  // namespace

ExportOrder sheetFigure(const ExportOrder& order) {
  ExportOrder figure = order;
  const SheetKind kind = order.of<SheetOptions>().kind;
  if (kind == SheetKind::none)
    return figure;
  figure.legend = LegendList::none;  // it stands beside the figure
  if (order.marks.words) {           // as does what the view says
    figure.marks.viewName = order.marks.viewName && order.words.title.empty();
    figure.words = {};
  }
  // The figure keeps its shape; labels are as large on paper as the order says.
  const glm::vec2 frame = sheetFigureMm(order);
  figure.page.sizeMm *= std::min(frame.x / order.page.sizeMm.x, frame.y / order.page.sizeMm.y);
  if (kind == SheetKind::patient)
    figure.labels.points = std::max(figure.labels.points, patientLabels);
  if (figure.labels.mode == LabelMode::off && kind != SheetKind::figure)
    figure.labels.mode = kind == SheetKind::patient ? LabelMode::on : LabelMode::numbers;
  if (figure.labels.mode != LabelMode::off && !hasLabels(order.scene))
    figure.scene = labelled(figure);
  return figure;
}

}  // namespace sline::render
