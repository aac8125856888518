// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/packages/asked_scene.h"

#include "tests/support/shapes.h"

namespace sline::test {

namespace {

model::AnnotationId addAskedBall(model::Scene& scene, const std::string& label,
                                 const glm::vec3& place, float radius) {
  model::Node node;
  node.name = label;
  node.style.gamma = Gamma::clamped(5.0f);
  node.mesh = moved(*sphere(radius, 3), 1.0f, place);
  const model::NodeId id = scene.append(std::move(node));
  model::Annotation annotation;
  annotation.text = label;
  annotation.anchors = {model::SurfacePoint{id, 0, {0.3f, 0.3f}}};
  annotation.found = true;
  return scene.appendAnnotation(annotation);
}

}  // namespace

render::ExportOrder askedOrder() {
  render::ExportOrder order;
  addAskedBall(order.scene, "left kidney", {40.0f, 0.0f, 0.0f}, 14.0f);
  addAskedBall(order.scene, hostileLabel, {0.0f, 0.0f, 0.0f}, 12.0f);
  addAskedBall(order.scene, "liver", {-40.0f, 0.0f, 0.0f}, 16.0f);
  addAskedBall(order.scene, "spleen", {-40.0f, 40.0f, 0.0f}, 5.0f);
  std::vector<model::Annotation> annotations = order.scene.annotations();
  annotations.front().texts["la"] = "Ren sinister";
  order.scene.setAnnotations(std::move(annotations));
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 16.0f / 9.0f);
  order.viewName = "Lobus liver / front";
  order.page.dpi = 60.0f;
  return order;
}

}  // namespace sline::test
