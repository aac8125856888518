// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <glm/geometric.hpp>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/sections/new_section.h"
#include "widgets/sections/section_position.h"

Q_DECLARE_METATYPE(glm::vec3)

using namespace sline;
using namespace sline::widgets;

class NewSectionTest : public QObject {
  Q_OBJECT

  static model::Scene body() {
    model::Scene scene;
    const model::NodeId group = scene.append({.name = "kidneys"});
    for (const float x : {-60.0f, 80.0f})
      scene.append({.parent = group,
                    .name = x < 0 ? "right kidney" : "left kidney",
                    .mesh = test::moved(*test::sphere(20.0f, 2), 1.0f, {x, 0.0f, 0.0f})});
    scene.append({.name = "bladder",
                  .mesh = test::moved(*test::sphere(20.0f, 2), 1.0f, {0.0f, 10.0f, -80.0f})});
    return scene;
  }

 private slots:
  /// Whatever the kind of section, the part towards the eye is taken away, and the plane goes
  /// through the place.
  void cutFaceLooksAtTheEye_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("view");
    QTest::addColumn<glm::vec3>("normal");
    using enum model::AnatomicalView;
    const auto row = [](const char* name, SectionKind kind, model::AnatomicalView view,
                        glm::vec3 normal) {
      QTest::newRow(name) << int(kind) << int(view) << normal;
    };
    row("sagittal from the left", SectionKind::sagittal, left, {1, 0, 0});
    row("sagittal from the right", SectionKind::sagittal, right, {-1, 0, 0});
    row("coronal from behind", SectionKind::coronal, posterior, {0, 1, 0});
    row("axial from below", SectionKind::axial, inferior, {0, 0, -1});
    row("facing from the front", SectionKind::facing, anterior, {0, -1, 0});
    row("facing from above", SectionKind::facing, superior, {0, 0, 1});
  }
  void cutFaceLooksAtTheEye() {
    QFETCH(int, kind);
    QFETCH(int, view);
    QFETCH(glm::vec3, normal);
    const model::Scene scene = body();
    const model::Camera camera =
        model::anatomicalCamera(model::AnatomicalView(view), scene.visibleBounds(), 1.0f);
    const model::Section middle = newSection(scene, camera, {.kind = SectionKind(kind)});
    QVERIFY(glm::length(middle.plane.normal - normal) < 1e-5f);
    QVERIFY(std::abs(middle.plane.distance(scene.visibleBounds().centre())) < 1e-3);
    const glm::vec3 place(12.0f, -7.0f, 31.0f);
    const model::Section there =
        newSection(scene, camera, {.kind = SectionKind(kind), .through = place});
    QVERIFY(glm::length(there.plane.normal - normal) < 1e-5f);
    QVERIFY(std::abs(there.plane.distance(place)) < 1e-3);
  }

  void namesAreFresh() {
    model::Scene scene = body();
    const SectionWish wish{.kind = SectionKind::axial};
    for (const char* name : {"Axial section", "Axial section 2", "Axial section 3"}) {
      const model::Section section = newSection(scene, {}, wish);
      QCOMPARE(QString::fromStdString(section.name), QString(name));
      scene = model::withSection(scene, section).scene;
    }
  }

  void ofAGroupAlone() {
    const model::Scene scene = body();
    const model::NodeId group = scene.named("kidneys").front();
    const NodeIds kidneys = scene.structuresBelow(group);
    const model::NodeId bladder = scene.named("bladder").front();
    QVERIFY(commonNode(scene, {}) == model::rootId);
    QVERIFY(commonNode(scene, {kidneys[0]}) == kidneys[0]);
    QVERIFY(commonNode(scene, kidneys) == group);
    QVERIFY(commonNode(scene, {kidneys[0], group}) == group);
    QVERIFY(commonNode(scene, {kidneys[0], bladder}) == model::rootId);
    const model::Section section =
        newSection(scene, {}, {.kind = SectionKind::sagittal, .scope = group});
    QVERIFY(section.scope == group);
    QCOMPARE(std::abs(section.plane.offset), 10.0f);  // the middle of the kidneys
    Session session;
    session.apply("body", {scene, true});
    QCOMPARE(scopeText(session, section.scope), QStringLiteral("kidneys"));
    QCOMPARE(scopeText(session, model::rootId), QStringLiteral("Whole scene"));
  }

  void positions_data() {
    QTest::addColumn<glm::vec3>("normal");
    QTest::addColumn<float>("offset");
    QTest::addColumn<double>("position");
    QTest::addColumn<QString>("text");
    const QString space = QChar(QChar::Nbsp);
    QTest::newRow("left") << glm::vec3(1, 0, 0) << 12.0f << 12.0 << "L" + space + "12.0 mm";
    QTest::newRow("left, the other side kept")
        << glm::vec3(-1, 0, 0) << -12.0f << 12.0 << "L" + space + "12.0 mm";
    QTest::newRow("right") << glm::vec3(1, 0, 0) << -3.5f << -3.5 << "R" + space + "3.5 mm";
    QTest::newRow("front") << glm::vec3(0, -1, 0) << 8.0f << -8.0 << "A" + space + "8.0 mm";
    QTest::newRow("below") << glm::vec3(0, 0, 1) << -30.0f << -30.0 << "I" + space + "30.0 mm";
    QTest::newRow("oblique") << glm::vec3(0.6f, 0.8f, 0) << -5.0f << -5.0 << "-5.0 mm";
  }
  void positions() {
    QFETCH(glm::vec3, normal);
    QFETCH(float, offset);
    QFETCH(double, position);
    QFETCH(QString, text);
    const model::Plane plane{.normal = normal, .offset = offset};
    QCOMPARE(positionOf(plane), position);
    QCOMPARE(positionText(plane, model::Scene()), text);
    QVERIFY(movedTo(plane, position) == plane);
    QCOMPARE(positionOf(movedTo(plane, 44.0)), 44.0);
    QCOMPARE(positionOf(flipped(flipped(plane))), position);
    // An anatomical plane stays where it is whichever side is kept.
    if (axisAcross(plane))
      QCOMPARE(positionOf(flipped(plane)), position);
  }
};

SLINE_TEST_WITH_EVENTS(NewSectionTest)
#include "new_section_test.moc"
