// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/gltf/gltf_sample.h"

#include "render/export/gltf/gltf_document.h"
#include "tests/support/shapes.h"

namespace sline::test {

model::NodeId add(model::Scene& scene, const std::string& name, model::NodeId parent,
                  const model::MeshPtr& mesh) {
  model::Node node;
  node.name = name;
  node.parent = parent;
  node.mesh = mesh;
  return scene.append(std::move(node));
}

void setStyle(model::Scene& scene, model::NodeId id, const model::Style& style) {
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (node.id == id)
      node.style = style;
  scene.setNodes(std::move(nodes));
}

Sample sample() {
  Sample s;
  const auto organs = add(s.scene, "Organs", model::rootId);
  const auto ball = test::sphere(10.0f, 1);
  s.left = add(s.scene, "left ball", organs, test::moved(*ball, 1.0f, {100.0f, 5.0f, 3.0f}));
  s.front = add(s.scene, "front ball", organs, test::moved(*ball, 0.5f, {-7.0f, -80.0f, 2.0f}));
  const auto more = add(s.scene, "More of them", model::rootId);
  s.top = add(s.scene, "top ball", more, test::moved(*ball, 2.0f, {-9.0f, 4.0f, 150.0f}));
  add(s.scene, "low ball", more, test::moved(*ball, 1.0f, {20.0f, 0.0f, -120.0f}));
  s.hidden = add(s.scene, "hidden ball", organs, test::moved(*ball, 1.0f, {0.0f, 0.0f, -90.0f}));
  setStyle(s.scene, s.left,
           {.colour = Colour{255, 128, 0},
            .inkColour = Colour{0, 0, 128},
            .gamma = Gamma::clamped(3.5f),
            .opacity = Opacity::clamped(0.5f)});
  setStyle(s.scene, s.hidden, {.visible = false});
  model::Annotation label;
  label.text = "Bällchen „links“";
  label.texts["la"] = "globulus";
  label.anchors = {model::SurfacePoint{s.left, 3, {0.25f, 0.25f}}};
  const auto shown = s.scene.appendAnnotation(label);
  model::Annotation distance;
  distance.kind = model::AnnotationKind::distance;
  distance.anchors = {glm::vec3(1.0f, 2.0f, 3.0f), glm::vec3(4.0f, 5.0f, 6.0f)};
  s.scene.appendAnnotation(distance);
  label.text = "not seen";
  label.visible = false;
  s.scene.appendAnnotation(label);
  model::View view{.name = "Von vorn", .camera = {}};
  view.looks = {{s.front, {.gamma = Gamma::clamped(1.0f)}, {}}, {s.hidden, {.visible = true}, {}}};
  view.annotations = {shown};
  view.words = {.title = {"Von vorn", {{"en", "From the *front*"}}},
                .text = {"Die **Bälle** <b>", {{"la", "Globuli"}}},
                .notes = {"for nobody else", {}}};
  model::View flat{.name = "Flach", .camera = {.projection = model::Projection::orthographic}};
  flat.sections = {{.name = "cut", .plane = {{1.0f, 0.0f, 0.0f}, 20.0f}}};
  s.scene.setViews({view, flat});
  s.scene.appendSection({.name = "middle", .plane = {{0.0f, 1.0f, 0.0f}, 10.0f}});
  return s;
}

render::ExportOrder orderOf(model::Scene scene) {
  render::ExportOrder order;
  order.scene = std::move(scene);
  return order;
}

std::string bytesOf(const model::Scene& scene) {
  const auto bytes = render::glbBytes(orderOf(scene), {});
  return bytes.ok() ? *bytes : std::string();
}

}  // namespace sline::test
