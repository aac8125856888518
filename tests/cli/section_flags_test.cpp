// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/section_flags.h"

#include <QTest>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::cli {

using model::AnatomicalView;

class SectionFlagsTest : public QObject {
  Q_OBJECT

 private slots:
  void understood_data();
  void understood();
  void refused_data();
  void refused();
  void halfTowardsTheCameraGoes_data();
  void halfTowardsTheCameraGoes();
  void facesAreSaid_data();
  void facesAreSaid();
  void groupsAreCutByOnePlane();
  void flagsWithoutSectionAreRefused();
};

void SectionFlagsTest::understood_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("axis");
  QTest::addColumn<double>("mm");     // 1e9: left open
  QTest::addColumn<QString>("kept");  // empty: left open
  QTest::newRow("bare") << "sagittal" << 0 << 1e9 << "";
  QTest::newRow("case") << "Axial" << 2 << 1e9 << "";
  QTest::newRow("place") << "coronal=-12.5" << 1 << -12.5 << "";
  QTest::newRow("side") << "sagittal:right" << 0 << 1e9 << "right";
  QTest::newRow("both") << "axial=30:Superior" << 2 << 30.0 << "superior";
}

void SectionFlagsTest::understood() {
  QFETCH(QString, text);
  QFETCH(int, axis);
  QFETCH(double, mm);
  QFETCH(QString, kept);
  const Result<SectionText> section = parseSection(text.toStdString());
  QVERIFY(section.ok());
  QVERIFY(!section->plane);
  QCOMPARE(section->axis, axis);
  QCOMPARE(double(section->mm.value_or(1e9f)), mm);
  QCOMPARE(section->kept, model::anatomicalViewNamed(kept.toStdString()));
}

void SectionFlagsTest::refused_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<bool>("right");
  QTest::newRow("a plane") << "1,0,0,5" << true;
  QTest::newRow("negative") << "-1,-0.5,0,-5" << true;
  QTest::newRow("three numbers") << "1,0,0" << false;
  QTest::newRow("five numbers") << "1,0,0,5,6" << false;
  QTest::newRow("no direction") << "0,0,0,5" << false;
  QTest::newRow("a letter") << "1,0,a,5" << false;
  QTest::newRow("nothing") << "" << false;
  QTest::newRow("unknown plane") << "oblique" << false;
  QTest::newRow("no number") << "axial=" << false;
  QTest::newRow("not finite") << "axial=inf" << false;
  QTest::newRow("side of another plane") << "sagittal:superior" << false;
  QTest::newRow("no side") << "sagittal:" << false;
}

void SectionFlagsTest::refused() {
  QFETCH(QString, text);
  QFETCH(bool, right);
  const Result<SectionText> section = parseSection(text.toStdString());
  QCOMPARE(section.ok(), right);
  if (!right)
    QVERIFY(!section.error().remedy.empty());
  else
    QVERIFY(section->plane && !model::planeFault(*section->plane));
}

void SectionFlagsTest::halfTowardsTheCameraGoes_data() {
  QTest::addColumn<QString>("section");
  QTest::addColumn<int>("view");
  QTest::addColumn<int>("kept");
  const auto row = [](const char* section, AnatomicalView view, AnatomicalView kept) {
    QTest::addRow("%s seen from %s", section, model::anatomicalViewNames[std::size_t(view)].data())
        << section << int(view) << int(kept);
  };
  using enum AnatomicalView;
  row("sagittal", right, left);  // the midsagittal plate of the left half
  row("sagittal", left, right);
  row("sagittal", anterior, left);   // edge-on: left, posterior, superior
  row("axial", inferior, superior);  // as CT slices are hung
  row("axial", superior, inferior);
  row("axial", anterior, superior);
  row("coronal", anterior, posterior);
  row("coronal", posterior, anterior);
  row("coronal", left, posterior);
  row("sagittal:right", right, right);  // a named side counts
  row("-1,0,0,0", left, left);
}

void SectionFlagsTest::halfTowardsTheCameraGoes() {
  QFETCH(QString, section);
  QFETCH(int, view);
  QFETCH(int, kept);
  model::Scene scene;
  model::Node node;
  node.name = "ball";
  node.mesh = test::sphere(10.0f, 2);
  scene.append(node);
  const model::Camera camera =
      model::anatomicalCamera(AnatomicalView(view), scene.visibleBounds(), 1.5f);
  SectionsSpec spec;
  spec.sections.push_back(*parseSection(section.toStdString()));
  const Result<model::Scene> cut = sectioned(scene, spec, camera);
  QVERIFY(cut.ok());
  QCOMPARE(cut->sections().size(), std::size_t(1));
  const model::Plane& plane = cut->sections()[0].plane;
  glm::vec3 side(0.0f);
  const auto keptSide = AnatomicalView(kept);
  side[model::axisOf(keptSide)] = keptSide == AnatomicalView::left ||
                                          keptSide == AnatomicalView::posterior ||
                                          keptSide == AnatomicalView::superior
                                      ? 5.0f
                                      : -5.0f;
  QVERIFY(plane.keeps(side));
  QVERIFY(!plane.keeps(-side));
}

void SectionFlagsTest::facesAreSaid_data() {
  QTest::addColumn<int>("faces");  // -1: refused
  QTest::newRow("") << int(model::Section().faces);
  QTest::newRow("off") << int(model::CutFaces::off);
  QTest::newRow("tint") << int(model::CutFaces::tint);
  QTest::newRow("tissue") << int(model::CutFaces::tissue);
  QTest::newRow("bone") << -1;
}

void SectionFlagsTest::facesAreSaid() {
  QFETCH(int, faces);
  model::Scene scene;
  scene.append({.name = "ball", .mesh = test::sphere(10.0f, 1)});
  const auto spec = parseFlags({.sections = {"axial"}, .faces = QTest::currentDataTag()});
  QCOMPARE(spec.ok(), faces >= 0);
  if (!spec.ok())
    return;
  const Result<model::Scene> cut = sectioned(scene, *spec, {});
  QVERIFY(cut.ok());
  QCOMPARE(int(cut->sections()[0].faces), faces);
}

void SectionFlagsTest::groupsAreCutByOnePlane() {
  model::Scene scene;
  for (const float x : {-30.0f, 10.0f, 90.0f}) {
    model::Node node;
    node.name = "ball " + std::to_string(int(x));
    node.mesh = test::moved(*test::sphere(10.0f, 1), 1.0f, {x, 0, 0});
    scene.append(node);
  }
  SectionsSpec spec;
  spec.sections.push_back(*parseSection("sagittal:left"));
  spec.groups = {"ball 10", "BALL_90"};
  spec.hatched = true;
  const Result<model::Scene> cut = sectioned(scene, spec, {});
  QVERIFY(cut.ok());
  QCOMPARE(cut->sections().size(), std::size_t(2));
  for (const model::Section& section : cut->sections()) {
    QVERIFY(std::abs(section.plane.distance({50, 0, 0})) < 1e-4);
    QVERIFY(section.hatched);
  }
  QVERIFY(cut->sectionsOf(scene.nodes()[0].id).empty());
  spec.groups = {"liver"};
  QVERIFY(!sectioned(scene, spec, {}).ok());
}

void SectionFlagsTest::flagsWithoutSectionAreRefused() {
  QVERIFY(cli::parseFlags(SectionFlags{}).ok());
  QVERIFY(!cli::parseFlags(SectionFlags{.groups = {"liver"}}).ok());
  QVERIFY(!cli::parseFlags(SectionFlags{.hatched = true}).ok());
  QVERIFY(cli::parseFlags(SectionFlags{.sections = {"axial"}, .groups = {"liver"}}).ok());
}

}  // namespace sline::cli

SLINE_TEST_WITH_EVENTS(sline::cli::SectionFlagsTest)
#include "section_flags_test.moc"
