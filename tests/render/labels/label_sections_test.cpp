// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <glm/geometric.hpp>

#include "render/labels/seen/seen_map.h"
#include "tests/render/labels/shown_labels.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;
using sline::test::front;
using sline::test::paper;
using sline::test::point;
using sline::test::shown;

class LabelSectionsTest : public QObject {
  Q_OBJECT
 private slots:
  /// Of faces of one cut the innermost is seen, as in pictures, whatever the order of the scene,
  /// and what has no face of its own colour covers none: nothing lies in front of anything.
  void theInnermostFaceOfACutIsSeen_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<QString>("around");
    QTest::addColumn<bool>("first");
    for (const float gamma : {1.0f, 3.0f, 5.0f})
      for (const char* around : {"BODY", "skin", "bone"})
        for (const bool first : {true, false})
          QTest::addRow("%s at %g, %s", around, double(gamma), first ? "first" : "last")
              << gamma << QString(around) << first;
  }
  void theInnermostFaceOfACutIsSeen() {
    QFETCH(float, gamma);
    QFETCH(QString, around);
    QFETCH(bool, first);
    model::Scene scene;
    std::vector<model::NodeId> inner;
    const auto add = [&](const std::string& name, float radius, const glm::vec3& at) {
      model::Node node{.name = name, .mesh = test::moved(*test::sphere(1.0f, 5), radius, at)};
      node.style.gamma = Gamma::clamped(gamma);
      return scene.append(node);
    };
    const auto addHull = [&] { return add(around.toStdString(), 60.0f, {}); };
    model::NodeId hull;
    if (first)
      hull = addHull();
    inner = {add("Heart", 20.0f, {-25.0f, 3.0f, 0.0f}), add("Lt Lung", 14.0f, {22.0f, 0.0f, 9.0f})};
    if (!first)
      hull = addHull();
    scene.appendSection({.plane = {.normal = {0.0f, -1.0f, 0.0f}, .offset = 0.0f}});
    for (const model::NodeId id : inner)
      point(scene, id, {0.0f, 1.0f, 0.3f});
    std::vector<model::Annotation> annotations = scene.annotations();
    for (model::Annotation& annotation : annotations) {
      const auto& on = std::get<model::SurfacePoint>(annotation.anchors.front());
      annotation.text = scene.find(on.structure)->name;
      annotation.found = true;
    }
    scene.setAnnotations(annotations);
    const std::vector<ShownLabel> labels = shown(scene);
    QCOMPARE(labels.size(), std::size_t(2));
    const Screen screen(front(), paper);
    const std::array<glm::vec3, 2> middles{glm::vec3(-25.0f, 0.0f, 0.0f), {22.0f, 0.0f, 9.0f}};
    const std::array<float, 2> radii{std::sqrt(400.0f - 9.0f), 14.0f};
    const float scale = screen.place({1.0f, 0.0f, 0.0f})->x - screen.place({})->x;
    for (std::size_t i = 0; i < 2; ++i) {
      QVERIFY(!labels[i].item.hidden);
      const float off = glm::distance(labels[i].item.places.front(), *screen.place(middles[i]));
      QVERIFY2(off < 0.8f * radii[i] * scale, qPrintable(QString::number(double(off))));
    }
    const SeenMap map(scene, screen);
    for (const SeenCover& cover : map.covers())
      QVERIFY2(cover.share < 0.05f, scene.find(cover.before)->name.c_str());
    // The hull shows around them.
    const auto place = map.find(hull);
    QVERIFY(place && !place->hidden);
    for (std::size_t i = 0; i < 2; ++i)
      QVERIFY(glm::distance(place->place, *screen.place(middles[i])) > 0.98f * radii[i] * scale);
  }

  /// A face that shows clearly is pointed at, rather than the rim beside it that the label had
  /// without the cut.
  void theFaceOfACutIsPreferred() {
    model::Scene scene;
    model::Node node{.name = "kidney", .mesh = test::sphere(40.0f, 5)};
    node.style.gamma = Gamma::clamped(5.0f);
    const model::NodeId id = scene.append(node);
    scene.appendSection(
        {.plane = {.normal = glm::normalize(glm::vec3(0.0f, -1.0f, 0.7f)), .offset = 0.0f}});
    const Screen screen(front(), paper);
    const SeenMap map(scene, screen);
    point(scene, id, {0.0f, -0.3f, -0.95f});
    const model::Anchor rim = scene.annotations().front().anchors.front();
    for (const auto& before : {std::optional<model::Anchor>(), std::optional(rim)}) {
      const auto place = map.find(id, before);
      QVERIFY(place && !place->hidden);
      QVERIFY(std::holds_alternative<glm::vec3>(place->anchor));
    }
  }

  /// A cut face hides the distance that lies behind it, whatever the structure's fill; beside it
  /// nothing is hidden, and what has no face has none to hide with.
  void aCutFaceHidesADistance() {
    for (const bool solid : {true, false}) {
      model::Scene scene;
      model::MeshPtr mesh = test::sphere(40.0f, 4);
      if (!solid) {
        std::vector<model::Triangle> some(mesh->triangles().begin(), mesh->triangles().end());
        some.resize(some.size() * 3 / 4);
        mesh = std::make_shared<const model::Mesh>(
            *model::Mesh::create({mesh->positions().begin(), mesh->positions().end()}, some));
      }
      model::Node node{.name = "protein", .mesh = mesh};
      node.style.gamma = Gamma::clamped(2.0f);
      node.style.fill = model::Fill::none;
      scene.append(node);
      scene.appendSection({.plane = {.normal = {0.0f, -1.0f, 0.0f}, .offset = 0.0f}});
      const auto measure = [&scene](const glm::vec3& from, const glm::vec3& to) {
        scene.appendAnnotation({.kind = model::AnnotationKind::distance, .anchors = {from, to}});
      };
      measure({-5.0f, 12.0f, 3.3f}, {6.0f, 12.0f, 7.1f});
      measure({-5.0f, 60.0f, 3.3f}, {6.0f, 60.0f, 7.1f});
      measure({-5.0f, -10.0f, 3.3f}, {6.0f, -10.0f, 7.1f});
      measure({60.0f, 12.0f, 3.3f}, {70.0f, 12.0f, 3.3f});
      const std::vector<ShownLabel> labels = shown(scene);
      QCOMPARE(labels.size(), std::size_t(4));
      QCOMPARE(labels[0].item.hidden, solid);
      QCOMPARE(labels[1].item.hidden, solid);
      QVERIFY(!labels[2].item.hidden);
      QVERIFY(!labels[3].item.hidden);
    }
  }
};

SLINE_TEST(LabelSectionsTest)
#include "label_sections_test.moc"
