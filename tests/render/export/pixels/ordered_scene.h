// SPDX-License-Identifier: Apache-2.0
// Makes an order with all that a picture can hold: lines, hatching, shading, a structure that is
// half clear, a cut face, labels.
#pragma once

#include "render/export/order/export_order.h"
#include "tests/render/picture/section_scenes.h"

namespace sline::test {

inline render::ExportOrder orderedPicture() {
  render::ExportOrder order;
  model::Scene& scene = order.scene;
  const model::NodeId ball =
      add(scene, moved(*sphere(30.0f, 4), 1.0f, {-30, 0, 5}), styled(3.0f, red));
  model::Style shaded = styled(5.0f, blue);
  add(scene, moved(*torus(20.0f, 7.0f, 96, 48), 1.0f, {28, 0, 10}), shaded);
  shaded.opacity = Opacity::clamped(0.5f);
  shaded.colour = Colour{40, 160, 60};
  add(scene, moved(*sphere(16.0f, 4), 1.0f, {5, -40, -18}), shaded);
  const model::NodeId cutBall =
      add(scene, moved(*sphere(14.0f, 4), 1.0f, {40, 5, -25}), styled(4.5f, red));
  cut(scene, model::AnatomicalView::posterior, 3.0f, cutBall);
  model::Annotation label;
  label.kind = model::AnnotationKind::callout;
  label.anchors = {model::SurfacePoint{ball, 0, {0.3f, 0.3f}}};
  label.text = "a ball";
  scene.appendAnnotation(label);
  order.camera = frontal(90.0f);
  order.page = {.sizeMm = {120.0f, 80.0f}, .dpi = 100.0f};
  order.labels.mode = render::LabelMode::on;
  return order;
}

}  // namespace sline::test
