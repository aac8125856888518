// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/slides/lesson.h"

#include <cmath>

#include "model/edit/views.h"
#include "render/export/slides/slide_options.h"
#include "tests/support/shapes.h"

namespace sline::test {

model::AnnotationId addBall(model::Scene& scene, const glm::vec3& at, float radius,
                            const std::string& label, model::AnnotationKind kind) {
  model::Node node;
  node.name = label;
  node.mesh = moved(*sphere(radius, 1), 1.0f, at);
  const auto id = scene.append(std::move(node));
  model::Annotation annotation;
  annotation.kind = kind;
  annotation.text = label;
  annotation.anchors = {model::SurfacePoint{id, 0, {0.3f, 0.3f}}};
  annotation.found = true;
  return scene.appendAnnotation(annotation);
}

void fitCamera(render::ExportOrder& order) {
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 16.0f / 9.0f);
}

render::ExportOrder lessonOf(const std::vector<std::string>& labels) {
  render::ExportOrder made;
  const int columns = std::max(1, int(std::ceil(std::sqrt(double(labels.size())))));
  for (int i = 0; i < int(labels.size()); ++i) {
    const int row = i / columns;
    addBall(made.scene, {30.0f * float(i % columns), 0.0f, -30.0f * float(row)}, 10.0f,
            labels[std::size_t(i)]);
  }
  fitCamera(made);
  made.viewName = "anterior";
  made.page.dpi = 60.0f;
  made.labels.mode = render::LabelMode::on;
  return made;
}

model::View& addView(render::ExportOrder& order, std::vector<model::View>& views,
                     const std::string& name) {
  views.push_back(model::viewOf(order.scene, order.camera, name));
  return views.back();
}

const std::vector<std::string>& oddNames() {
  static const std::vector<std::string> names{
      "Vena \"cava\" 'inferior'",
      "<b>Aorta</b> & </a:t>",
      "]]> <!-- \\ %s ${x}",
      "🫀 heart 🧠",
      "حوض عظم الفخذ",
      "עצם הירך & <b>",
      "a\x01 b\x0b c\x1b[31m\x7f",
      "\xff\xfe broken \xc3",
      "骨盆 — 大腿骨",
      "e\u0301\u0302\u0303\u202e abc \u202c\u200f",
      "tab\there\nand a line",
      std::string(300, 'x'),
      "Musculus " + std::string("longissimus ") + std::string(30, 'm') + " thoracis et lumborum",
      "   ",
  };
  return names;
}

render::ExportOrder oddLesson(int number) {
  const std::vector<std::string>& names = oddNames();
  const auto name = [&](int i) { return names[std::size_t(i) % names.size()]; };
  std::vector<std::string> labels;
  const int count = number % 10 == 9 ? 100 : 1 + number % 6;
  labels.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i)
    labels.push_back(count == 100 ? "label " + std::to_string(i + 1) : name(number + i));
  render::ExportOrder order = lessonOf(labels);
  std::vector<model::View> views;
  for (int i = 0; i < number % 4; ++i) {
    model::View& view = addView(order, views, name(number + i) + std::to_string(i));
    view.words.title.text = i == 1 ? name(number + 2 * i) : "";
    view.words.text.text = i == 2 ? "" : "**" + name(number + i) + "**\n- " + name(number + i + 1);
    view.words.text.texts["ar"] = name(4);
    view.words.notes.text = i == 0 ? name(number) + "\n\n" + name(number + 3) : "";
    if (number % 5 == 3)  // a view that shows nothing
      for (model::Look& look : *view.looks)
        look.style.visible = false;
  }
  order.scene.setViews(views);
  auto& slides = order.of<render::SlideOptions>();
  slides.shape = number % 3 == 2 ? render::SlideShape::standard : render::SlideShape::wide;
  slides.onClick = number % 2 == 1;
  slides.selfTest = number % 3 == 1;
  order.labels.language = number % 7 == 3 ? "ar" : "";
  if (number % 6 == 5)
    order.environment.background = render::Background::dark;
  order.page.dpi = 40.0f;
  if (count == 100)
    order.labels.points = 4.0f;
  return order;
}

}  // namespace sline::test
