// SPDX-License-Identifier: Apache-2.0
// Tests what of a scene a students' page holds, and how large scenes are simplified.
#include "model/edit/views.h"
#include "model/lengths/shortest_distance.h"
#include "model/scene/known_frame.h"
#include "render/export/students/page_order.h"
#include "render/export/students/students_file.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/render/export/students/page_parts.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns two finely meshed balls, the second painted, both labelled.
render::ExportOrder fineBalls() {
  render::ExportOrder order = lessonOf({"liver", "spleen"});
  std::vector<model::Node> nodes = order.scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i].mesh = moved(*sphere(10.0f, 4), 1.0f, {30.0f * float(i), 0.0f, 0.0f});
  model::Paint paint;
  for (const glm::vec3& place : nodes[1].mesh->positions())
    paint.push_back(place.z > 0.0f ? 255 : 0);
  nodes[1].paint = std::make_shared<const model::Paint>(paint);
  order.scene.setNodes(nodes);
  fitCamera(order);
  return order;
}

}  // namespace

class PageSceneTest : public QObject {
  Q_OBJECT

 private slots:
  void simplifiedOnlyWhereAsked() {
    const render::ExportOrder order = fineBalls();
    const render::SimplifiedScene same = render::simplifiedScene(order.scene, {}, {});
    QCOMPARE(same.errorMm, 0.0f);
    QVERIFY(same.scene == order.scene);
    QVERIFY(!factsOf(pageOf(order).html).contains("simplifiedMm"));
  }

  void byError() {
    const render::ExportOrder order = fineBalls();
    const render::SimplifiedScene simple =
        render::simplifiedScene(order.scene, {.errorMm = 0.2}, {});
    QVERIFY(simple.errorMm > 0.0f && simple.errorMm <= 0.2f);
    QVERIFY(render::trianglesOf(simple.scene) < render::trianglesOf(order.scene) / 2);
    // Labels stay where they are.
    for (std::size_t i = 0; i < 2; ++i) {
      const auto before = order.scene.placeOf(order.scene.annotations()[i].anchors.front());
      const auto after = simple.scene.placeOf(simple.scene.annotations()[i].anchors.front());
      QVERIFY(after && glm::distance(*before, *after) <= 0.3f);
    }
    const model::Node& painted = simple.scene.nodes()[1];
    QCOMPARE(painted.paint->size(), painted.mesh->positions().size());
    for (std::size_t i = 0; i < painted.paint->size(); ++i)
      if (const float z = painted.mesh->positions()[i].z; std::abs(z) > 2.0f)
        QCOMPARE(int((*painted.paint)[i]), z > 0.0f ? 255 : 0);
  }

  void byTriangles_data() {
    QTest::addColumn<int>("most");
    for (const int most : {6'000, 1'500})
      QTest::addRow("%d", most) << most;
  }
  void byTriangles() {
    QFETCH(int, most);
    const render::ExportOrder order = fineBalls();
    const render::SimplifiedScene simple =
        render::simplifiedScene(order.scene, {.triangles = most}, {});
    const auto triangles = int(render::trianglesOf(simple.scene));
    QVERIFY2(triangles <= most && triangles > most / 3, qPrintable(QString::number(triangles)));
    QVERIFY(simple.errorMm > 0.0f && simple.errorMm < 2.0f);
  }

  void whatIsSimplifiedIsSaid() {
    render::ExportOrder order = fineBalls();
    render::ExportNotes notes;
    const auto page = render::studentsPage(order, {.errorMm = 0.2},
                                           {[](double, std::string_view) { return true; }, &notes});
    QVERIFY(page.ok());
    const double said = factsOf(page->html)["simplifiedMm"];
    QVERIFY(said > 0.0 && said <= 0.2);
    QCOMPARE(notes.size(), std::size_t(1));
    QVERIFY(notes[0].kind == render::ExportNote::Kind::pageSimplified);
    QVERIFY(QString::fromStdString(notes[0].detail).toDouble() >= said);
  }

  /// A page tells no more of a distance than its picture does.
  void distancesSayHowSureTheyAre_data() {
    QTest::addColumn<float>("moved");
    QTest::addColumn<double>("errorMm");
    QTest::addColumn<QString>("told");
    QTest::newRow("as read") << 0.0f << 0.0 << "10 mm";
    QTest::newRow("smoothed by import") << 0.8f << 0.0 << "≈ 10 mm";
    QTest::newRow("so far that they may touch") << 12.0f << 0.0 << "< 22 mm";
    QTest::newRow("simplified for the page") << 0.45f << 0.2 << "≈ 10 mm";
  }
  void distancesSayHowSureTheyAre() {
    QFETCH(float, moved);
    QFETCH(double, errorMm);
    QFETCH(QString, told);
    render::ExportOrder order = fineBalls();
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[0].provenance.displacementMm = moved;
    order.scene.setNodes(nodes);
    const auto distance = model::shortestDistance(order.scene, nodes[0].id, nodes[1].id);
    QVERIFY(distance);
    order.scene.setAnnotations({});
    order.scene.appendAnnotation(*distance);
    const auto page = render::studentsPage(order, {.errorMm = errorMm},
                                           {[](double, std::string_view) { return true; }});
    QVERIFY(page.ok());
    const nlohmann::json label = factsOf(page->html)["labels"][0]["words"]["en"][0][0];
    QCOMPARE(QString::fromStdString(label["text"]).replace(QChar(QChar::Nbsp), ' '), told);
  }

  void notes() {
    render::ExportOrder order = lessonOf({"liver"});
    QVERIFY(render::studentsNotes(order).empty());
    std::vector<model::Annotation> annotations = order.scene.annotations();
    annotations[0].kind = model::AnnotationKind::callout;
    order.scene.setAnnotations(annotations);
    QCOMPARE(render::studentsNotes(order).size(), std::size_t(1));
    QVERIFY(render::studentsNotes(order)[0].kind == render::ExportNote::Kind::quizEmpty);
    order.of<render::StudentsOptions>().quiz = render::QuizMode::off;
    QVERIFY(render::studentsNotes(order).empty());
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[0].mesh = sphere(10.0f, 8);
    order.scene.setNodes(nodes);
    QCOMPARE(render::studentsNotes(order).size(), std::size_t(1));
    QVERIFY(render::studentsNotes(order)[0].kind == render::ExportNote::Kind::pageLarge);
    QCOMPARE(render::studentsNotes(order)[0].detail, std::string("1.3"));
    order.of<render::StudentsOptions>().triangles = 100'000;
    QVERIFY(render::studentsNotes(order).empty());
  }

  /// A scene without views has one: what is shown.
  void oneViewAtLeast() {
    render::ExportOrder order = lessonOf({"liver"});
    order.words.title.text = "As it is";
    const render::ExportOrder page = render::pageOrder(order);
    QCOMPARE(page.scene.views().size(), std::size_t(1));
    QVERIFY(page.scene.views()[0].camera == order.camera);
    QCOMPARE(page.scene.views()[0].words.title.text, std::string("As it is"));
  }

  /// A scene without labels has one for each structure, whichever side one turns to the eye; those
  /// of a view are of what is seen in it.
  void labelsAreFound() {
    render::ExportOrder order = lessonOf({"liver", "spleen"});
    order.scene.setAnnotations({});
    std::vector<model::Node> nodes = order.scene.nodes();
    // The spleen lies behind the liver, a little smaller.
    nodes[0].mesh = sphere(10.0f, 4);
    nodes[1].mesh = moved(*sphere(8.0f, 4), 1.0f, {0.0f, 30.0f, 0.0f});
    for (model::Node& node : nodes)
      node.style.gamma = Gamma::clamped(5.0f);
    order.scene.setNodes(nodes);
    fitCamera(order);
    std::vector<model::View> views;
    addView(order, views, "Front");
    model::View& behind = addView(order, views, "Behind");
    behind.camera = model::anatomicalCamera(model::AnatomicalView::posterior,
                                            order.scene.visibleBounds(), 1.5f);
    order.scene.setViews(views);
    const render::ExportOrder page = render::pageOrder(order);
    QVERIFY(page.of<render::StudentsOptions>().foundLabels);
    const auto& labels = page.scene.annotations();
    QCOMPARE(labels.size(), std::size_t(2));
    QCOMPARE(labels[0].text, std::string("liver"));
    QVERIFY(labels[0].visible && !labels[1].visible);
    const auto& of = page.scene.views();
    QVERIFY(*of[0].annotations == std::vector{labels[0].id});
    QVERIFY(*of[1].annotations == std::vector{labels[1].id});
    const nlohmann::json facts = factsOf(pageOf(order).html);
    QCOMPARE(facts["labels"].size(), std::size_t(2));
    QVERIFY(facts["labelsFound"] == nlohmann::json(true));
    QVERIFY(!facts.contains("sideless"));
    QVERIFY(!factsOf(pageOf(lessonOf({"liver"})).html).contains("labelsFound"));
  }

  void moleculesHaveNoSides() {
    render::ExportOrder order = lessonOf({"chain", "ligand"});
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes) {
      node.provenance.file = "1crn.pdb";
      node.provenance.frame = model::fileFrame;
      node.provenance.unitReason = model::angstromReason;
    }
    order.scene.setNodes(std::move(nodes));
    QVERIFY(factsOf(pageOf(order).html)["sideless"] == nlohmann::json(true));
    QVERIFY(drawnUnit(render::pageOrder(order).scene) == model::DrawnUnit::angstrom);
  }

  void whatNobodySees() {
    render::ExportOrder order = lessonOf({"liver", "spleen"});
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes) {
      node.unread = "{\"a\":1}";
      node.provenance.file = "secret.obj";
      node.provenance.sliceMm = 2.0f;
    }
    nodes[1].style.visible = false;
    order.scene.setNodes(nodes);
    model::Focus focus;
    focus.targets = {nodes[1].id};
    focus.unread = "{}";
    order.scene.setFocus(focus);
    model::Section section{.name = "secret", .scope = nodes[1].id};
    order.scene.appendSection(section);
    section.scope = model::rootId;
    order.scene.appendSection(section);
    const model::Scene scene = render::pageOrder(order).scene;
    QCOMPARE(scene.nodes().size(), std::size_t(1));
    QVERIFY(scene.nodes()[0].unread.empty() && scene.nodes()[0].provenance.file.empty());
    QCOMPARE(scene.nodes()[0].provenance.sliceMm, 2.0f);
    QVERIFY(scene.focus().targets.empty() && scene.focus().unread.empty());
    QCOMPARE(scene.sections().size(), std::size_t(1));
    QCOMPARE(scene.sections()[0].name, std::string("1"));
    QCOMPARE(scene.annotations().size(), std::size_t(1));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::PageSceneTest)
#include "page_scene_test.moc"
