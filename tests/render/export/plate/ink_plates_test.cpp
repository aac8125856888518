// SPDX-License-Identifier: Apache-2.0
// Tests that black ink alone shows the same as colours do, with the same labels in the same places.
#include <QDir>
#include <QTest>
#include <algorithm>

#include "model/demo/demo.h"
#include "model/edit/views.h"
#include "render/export/order/ink_alone.h"
#include "render/export/plate/figure_plate.h"
#include "render/lettering/typesetting.h"
#include "render/vectors/vector_drawing.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

/// Returns a demo with a label on each of its structures, seen as that view of its own.
ExportOrder demoOrder(model::DemoName name, std::size_t view) {
  ExportOrder order;
  model::Scene scene = model::demo(name, model::Sex::male, QDir::tempPath().toStdString());
  std::vector<model::Annotation> labels;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup()) {
      model::Annotation label;
      label.id = model::AnnotationId{labels.size() + 1};
      label.text = node.name;
      label.anchors = {model::SurfacePoint{.structure = node.id}};
      label.found = true;
      labels.push_back(label);
    }
  scene.setAnnotations(labels);
  order.page.sizeMm = {200.0f, 150.0f};
  order.scene = scene;
  order.camera = model::anatomicalCamera(
      view == 0 ? model::AnatomicalView::anterior : model::AnatomicalView::left,
      scene.visibleBounds(), 200.0f / 150.0f);
  if (view < scene.views().size()) {
    const model::View& shown = scene.views()[view];
    order.camera = shown.camera;
    order.scene = model::withViewApplied(scene, shown).scene;
    order.scene.setAnnotations(labels);
  }
  order.labels.mode = LabelMode::on;
  return order;
}

ExportOrder inInk(ExportOrder order) {
  leaveInkAlone(order);
  return order;
}

/// Returns the lines that a drawing shows of a structure, in millimetres; those behind others as
/// far as these let them show.
double inkOf(const VectorDrawing& drawing, model::NodeId id) {
  double all = 0.0;
  for (const VectorStructure& structure : drawing.structures)
    if (structure.id == id)
      for (const VectorLines& lines : structure.lines)
        for (const VectorShape& shape : lines.shapes)
          if (!lines.hidden && shape.light > 0.1f)
            for (const Curve& curve : shape.path)
              all += double(curve.pieces.size());
  return all;
}

}  // namespace

class InkPlatesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Typesetting> m_typesetting;

 private slots:
  void initTestCase() {
    auto made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }
  void cleanupTestCase() { m_typesetting.reset(); }

  void sameLabels_data() {
    QTest::addColumn<int>("name");
    QTest::addColumn<int>("view");
    for (std::size_t name = 0; name < model::demoNames.size(); ++name)
      for (int view = 0; view < 2; ++view)
        QTest::addRow("%s, view %d", model::demoNames[name].data(), view + 1) << int(name) << view;
  }
  void sameLabels() {
    QFETCH(int, name);
    QFETCH(int, view);
    const ExportOrder order = demoOrder(model::DemoName(name), std::size_t(view));
    const FigurePlate colour = figurePlate(order);
    const FigurePlate ink = figurePlate(inInk(order));
    const std::vector<PlacedLabel>& one = colour.labels->layout.labels;
    const std::vector<PlacedLabel>& other = ink.labels->layout.labels;
    QVERIFY2(one.size() >= 2, qPrintable(QString::number(one.size())));
    QCOMPARE(other.size(), one.size());
    for (const PlacedLabel& label : one) {
      const PlacedLabel* same = ink.labels->layout.find(label.id);
      QVERIFY(same);
      QVERIFY(same->box.low == label.box.low && same->box.high == label.box.high);
      QVERIFY(same->leader == label.leader && same->hidden == label.hidden);
    }
    QVERIFY(ink.notes == colour.notes);
  }

  /// What a colour picture shows through a wash, a veil or what is transparent, ink shows, too;
  /// what is hidden stays hidden, and the label's line is dashed in both or in neither.
  void sameThings_data() {
    QTest::addColumn<int>("fill");
    QTest::addColumn<float>("gamma");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<bool>("shows");
    using model::Fill;
    const auto row = [](const char* name, Fill fill, float gamma, float opacity, bool shows) {
      QTest::newRow(name) << int(fill) << gamma << opacity << shows;
    };
    row("lines", Fill::none, 1.0f, 1.0f, true);
    row("wash", Fill::tint, 1.0f, 1.0f, true);
    row("veil", Fill::veil, 1.0f, 1.0f, true);
    row("hatched veil", Fill::veil, 3.0f, 1.0f, true);
    row("clear shade", Fill::none, 5.0f, 0.3f, true);
    row("paper", Fill::paper, 1.0f, 1.0f, false);
    row("shade", Fill::none, 5.0f, 1.0f, false);
  }
  void sameThings() {
    QFETCH(int, fill);
    QFETCH(float, gamma);
    QFETCH(float, opacity);
    QFETCH(bool, shows);
    ExportOrder order;
    const model::NodeId core = order.scene.append({.name = "core",
                                                   .style = {.gamma = Gamma::clamped(2.0f)},
                                                   .mesh = torus(20.0f, 7.0f, 60, 24)});
    order.scene.append({.name = "shell",
                        .style = {.gamma = Gamma::clamped(gamma),
                                  .opacity = Opacity::clamped(opacity),
                                  .fill = model::Fill(fill)},
                        .mesh = sphere(50.0f, 4)});
    model::Annotation label;
    label.id = model::AnnotationId{1};
    label.text = "core";
    label.anchors = {model::SurfacePoint{.structure = core}};
    label.found = true;
    order.scene.setAnnotations({label});
    order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                           order.scene.visibleBounds(), 160.0f / 90.0f);
    order.labels.mode = LabelMode::on;
    const ExportOrder inked = inInk(order);
    for (const ExportOrder* each : {&std::as_const(order), &inked}) {
      const Result<VectorDrawing> drawing =
          drawVectors(each->scene, each->camera, {.sizeMm = each->page.sizeMm});
      QVERIFY(drawing.ok());
      QCOMPARE(inkOf(*drawing, core) > 0.0, shows);
    }
    const FigurePlate colour = figurePlate(order);
    const FigurePlate ink = figurePlate(inked);
    QCOMPARE(ink.labels->layout.labels.size(), colour.labels->layout.labels.size());
    for (const PlacedLabel& placed : colour.labels->layout.labels)
      QCOMPARE(ink.labels->layout.find(placed.id)->hidden, placed.hidden);
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::InkPlatesTest)
#include "ink_plates_test.moc"
