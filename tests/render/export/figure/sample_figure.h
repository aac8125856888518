// SPDX-License-Identifier: Apache-2.0
// Makes figures for tests.
#pragma once

#include <QtTest>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "render/export/figure/figure_page.h"
#include "tests/support/shapes.h"

namespace sline::test {

using namespace render;

/// Balls in a row from the patient's right to the left, each with a label.
inline model::Scene rowOfBalls(int count) {
  model::Scene scene;
  std::vector<model::Annotation> labels;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at{30.0f * float(i) - 15.0f * float(count - 1), 0.0f, float(i % 2) * 20.0f};
    const std::string name = "ball number " + std::to_string(i + 1);
    const model::NodeId id = scene.append({.name = name,
                                           .style = {.gamma = Gamma::clamped(2.0f)},
                                           .mesh = moved(*sphere(12.0f, 3), 1.0f, at)});
    model::Annotation label;
    label.id = model::AnnotationId{std::uint64_t(i + 1)};
    label.text = name;
    label.anchors = {model::SurfacePoint{.structure = id}};
    label.found = true;
    labels.push_back(label);
  }
  scene.setAnnotations(std::move(labels));
  model::View view;
  view.name = "Saved";
  view.camera = model::fittedView(scene, model::AnatomicalView::anterior, 1.4f);
  scene.setViews({view});
  return scene;
}

inline const FigureScenes& scenes() {
  static const FigureScenes all{{"row.sline", std::make_shared<const model::Scene>(rowOfBalls(5))},
                                {"two.sline", std::make_shared<const model::Scene>(rowOfBalls(2))}};
  return all;
}

inline model::Figure fourPanels() {
  model::Figure figure{.scene = "row.sline"};
  figure.panels = {{.view = "anterior"},
                   {.view = "superior"},
                   {.view = "Saved", .camera = model::PanelCamera{.fit = true}},
                   {.inset = model::PanelInset{.of = "a", .part = {{30, 22}, {20, 15}}}}};
  return figure;
}

inline ComposedFigure drawn(const model::Figure& figure) {
  const Result<FigurePlan> plan = planFigure(figure, scenes());
  if (!plan.ok())
    qFatal("%s", plan.error().text().c_str());
  Result<ComposedFigure> composed = composeFigure(*plan, {});
  if (!composed.ok())
    qFatal("%s", composed.error().text().c_str());
  return std::move(*composed);
}

}  // namespace sline::test
