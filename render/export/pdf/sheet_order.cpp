// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_order.h"

#include <algorithm>
#include <array>

#include "model/anatomy/anatomical_names.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/labels/best_place.h"

namespace sline::render {

std::string structureName(const std::string& name, const std::string& language) {
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

namespace {

constexpr float patientLabels = 14.0f;  // points

/// The scene with a label for each structure that is seen, where it has no visible annotation.
model::Scene labelled(const ExportOrder& order) {
  model::Scene scene = order.scene;
  const auto& annotations = scene.annotations();
  if (std::any_of(annotations.begin(), annotations.end(),
                  [](const model::Annotation& a) { return a.visible; }))
    return scene;
  const Screen screen(order.camera, order.page.sizeMm);
  SightTrees trees;
  for (const model::Node& node : order.scene.nodes()) {
    if (node.isGroup())
      continue;
    const auto place = bestPlaceOn(order.scene, node.id, screen, trees);
    if (!place || place->hidden)
      continue;
    model::Annotation label;
    label.anchors = {place->point};
    label.text = structureName(node.name, order.labels.language);
    if (!label.text.empty())
      scene.appendAnnotation(std::move(label));
  }
  return scene;
}

}  // namespace

ExportOrder sheetFigure(const ExportOrder& order) {
  ExportOrder figure = order;
  const SheetKind kind = order.sheet.kind;
  if (kind == SheetKind::none)
    return figure;
  // The figure keeps its shape; labels are as large on paper as the order says.
  const glm::vec2 frame = sheetFigureMm(order);
  figure.page.sizeMm *= std::min(frame.x / order.page.sizeMm.x, frame.y / order.page.sizeMm.y);
  if (kind == SheetKind::patient)
    figure.labels.points = std::max(figure.labels.points, patientLabels);
  if (figure.labels.mode == LabelMode::off && kind != SheetKind::figure)
    figure.labels.mode = kind == SheetKind::patient ? LabelMode::on : LabelMode::numbers;
  if (figure.labels.mode != LabelMode::off)
    figure.scene = labelled(figure);
  return figure;
}

}  // namespace sline::render
