// SPDX-License-Identifier: Apache-2.0
#include "model/edit/sections.h"
#include "model/edit/look.h"

#include <QTest>

#include "model/edit/tree.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {
namespace {

/// Holds organs ( liver at x = 60, vessels ( vein ) ), bone.
struct Sample {
  Scene scene;
  NodeId organs, liver, vessels, vein, bone;
  Sample() {
    const MeshPtr ball = test::sphere(10.0f, 1);
    organs = add("organs", rootId, nullptr);
    liver = add("liver", organs, test::moved(*ball, 1.0f, {60, 20, -30}));
    vessels = add("vessels", organs, nullptr);
    vein = add("vein", vessels, ball);
    bone = add("bone", rootId, test::moved(*ball, 1.0f, {-100, 0, 0}));
  }
  NodeId add(const char* name, NodeId parent, MeshPtr mesh) {
    Node node;
    node.name = name;
    node.parent = parent;
    node.mesh = std::move(mesh);
    return scene.append(node);
  }
};

Section through(const glm::vec3& normal, float offset, NodeId scope = rootId) {
  Section section;
  section.plane = {normal, offset};
  section.scope = scope;
  return section;
}

}  // namespace

class SectionsTest : public QObject {
  Q_OBJECT

 private slots:
  void sidesAreTheirOwn_data();
  void sidesAreTheirOwn();
  void throughTheMiddle();
  void scopesReachDown();
  void addedChangedRemoved();
  void refused_data();
  void refused();
  void notMoreThanFit();
  void leaveWithWhatTheyCut();
  void belongToViews();
};

void SectionsTest::sidesAreTheirOwn_data() {
  QTest::addColumn<int>("side");
  QTest::addColumn<float>("x");
  QTest::addColumn<float>("y");
  QTest::addColumn<float>("z");
  const auto row = [](AnatomicalView side, float x, float y, float z) {
    QTest::newRow(anatomicalViewNames[std::size_t(side)].data()) << int(side) << x << y << z;
  };
  // LPS: +x is the patient's left, +y the back, +z the head.
  row(AnatomicalView::left, 1, 0, 0);
  row(AnatomicalView::right, -1, 0, 0);
  row(AnatomicalView::posterior, 0, 1, 0);
  row(AnatomicalView::anterior, 0, -1, 0);
  row(AnatomicalView::superior, 0, 0, 1);
  row(AnatomicalView::inferior, 0, 0, -1);
}

void SectionsTest::sidesAreTheirOwn() {
  QFETCH(int, side);
  QFETCH(float, x);
  QFETCH(float, y);
  QFETCH(float, z);
  const glm::vec3 towards(x, y, z);
  const glm::vec3 on(7.0f);
  const Plane plane = anatomicalPlane(AnatomicalView(side), 7.0f);
  QVERIFY(!planeFault(plane));
  QVERIFY(std::abs(plane.distance(on)) < 1e-6);
  QVERIFY(plane.keeps(on + towards));
  QVERIFY(!plane.keeps(on - towards));
  QCOMPARE(plane.distance(on - 3.0f * towards), 3.0);
}

void SectionsTest::throughTheMiddle() {
  Sample s;
  const Section whole = anatomicalSection(s.scene, rootId, AnatomicalView::left);
  QVERIFY(std::abs(whole.plane.distance({-20, 5, 5})) < 1e-4);  // between −110 and 70
  const Section organs = anatomicalSection(s.scene, s.organs, AnatomicalView::right);
  QVERIFY(std::abs(organs.plane.distance({30, 5, 5})) < 1e-4);
  QCOMPARE(organs.scope, s.organs);
  Style hidden;
  hidden.visible = false;
  const Scene without = withLook(s.scene, std::array{s.liver}, hidden).scene;
  QVERIFY(std::abs(anatomicalSection(without, s.organs, AnatomicalView::right)
                       .plane.distance({0, 5, 5})) < 1e-4);
  const Section given = anatomicalSection(s.scene, rootId, AnatomicalView::inferior, 12.0f);
  QVERIFY(std::abs(given.plane.distance({1, 2, 12})) < 1e-6);
  QCOMPARE(given.name, std::string("Axial section"));
}

void SectionsTest::scopesReachDown() {
  Sample s;
  s.scene = withSection(s.scene, through({1, 0, 0}, 0)).scene;
  s.scene = withSection(s.scene, through({0, 1, 0}, 0, s.organs)).scene;
  s.scene = withSection(s.scene, through({0, 0, 1}, 0, s.vein)).scene;
  QCOMPARE(s.scene.sectionsOf(s.bone).size(), std::size_t(1));
  QCOMPARE(s.scene.sectionsOf(s.liver).size(), std::size_t(2));
  QCOMPARE(s.scene.sectionsOf(s.vein).size(), std::size_t(3));
  QCOMPARE(s.scene.sectionsOf(s.vein).back().plane.normal, glm::vec3(0, 0, 1));
  Section off = s.scene.sections()[0];
  off.enabled = false;
  s.scene = withSectionChanged(s.scene, off.id, off).scene;
  QCOMPARE(s.scene.sectionsOf(s.bone).size(), std::size_t(0));
}

void SectionsTest::addedChangedRemoved() {
  Sample s;
  const Edited first = withSection(s.scene, through({1, 0, 0}, 5));
  QVERIFY(first.changed);
  const Edited second = withSection(first.scene, through({1, 0, 0}, 5));
  QVERIFY(second.changed);
  const SectionId a = second.scene.sections()[0].id;
  const SectionId b = second.scene.sections()[1].id;
  QVERIFY(a != b && a.value != 0);

  Section moved = second.scene.sections()[0];
  QVERIFY(!withSectionChanged(second.scene, a, moved).changed);
  moved.plane.offset = 6.0f;
  QVERIFY(!withSectionChanged(second.scene, SectionId{77}, moved).changed);
  const Edited changed = withSectionChanged(second.scene, b, moved);
  QVERIFY(changed.changed);
  QCOMPARE(changed.scene.sections()[0].plane.offset, 5.0f);
  QCOMPARE(changed.scene.sections()[1].plane.offset, 6.0f);
  QCOMPARE(changed.scene.sections()[1].id, b);

  const Edited removed = withoutSections(changed.scene, std::array{a});
  QVERIFY(removed.changed);
  QCOMPARE(removed.scene.sections().size(), std::size_t(1));
  QVERIFY(!withoutSections(removed.scene, std::array{a}).changed);
  // An id is never given twice.
  QVERIFY(withSection(removed.scene, moved).scene.sections().back().id != a);
}

void SectionsTest::refused_data() {
  QTest::addColumn<float>("x");
  QTest::addColumn<float>("offset");
  QTest::addColumn<quint64>("scope");
  QTest::addColumn<bool>("accepted");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  QTest::newRow("sound") << 1.0f << 3.0f << quint64(0) << true;
  QTest::newRow("normal of length 2") << 2.0f << 3.0f << quint64(0) << false;
  QTest::newRow("no normal") << 0.0f << 3.0f << quint64(0) << false;
  QTest::newRow("not a number") << nan << 3.0f << quint64(0) << false;
  QTest::newRow("offset not a number") << 1.0f << nan << quint64(0) << false;
  QTest::newRow("nothing to cut") << 1.0f << 3.0f << quint64(999) << false;
}

void SectionsTest::refused() {
  QFETCH(float, x);
  QFETCH(float, offset);
  QFETCH(quint64, scope);
  QFETCH(bool, accepted);
  const Sample s;
  QCOMPARE(withSection(s.scene, through({x, 0, 0}, offset, NodeId{scope})).changed, accepted);
  const Edited one = withSection(s.scene, through({0, 1, 0}, 0));
  const SectionId id = one.scene.sections()[0].id;
  QCOMPARE(withSectionChanged(one.scene, id, through({x, 0, 0}, offset, NodeId{scope})).changed,
           accepted);
}

void SectionsTest::notMoreThanFit() {
  Sample s;
  for (std::size_t i = 0; i < maximumSections; ++i) {
    const Edited edited = withSection(s.scene, through({1, 0, 0}, float(i), s.vein));
    QVERIFY(edited.changed);
    s.scene = edited.scene;
  }
  QVERIFY(!withSection(s.scene, through({1, 0, 0}, 9.0f)).changed);
  QVERIFY(withSection(s.scene, through({1, 0, 0}, 9.0f, s.bone)).changed);
}

void SectionsTest::leaveWithWhatTheyCut() {
  Sample s;
  s.scene = withSection(s.scene, through({1, 0, 0}, 0, s.vein)).scene;
  s.scene = withSection(s.scene, through({0, 1, 0}, 0)).scene;
  const Scene after = removed(s.scene, std::array{s.organs}).scene;
  QCOMPARE(after.sections().size(), std::size_t(1));
  QCOMPARE(after.sections()[0].scope, rootId);
}

void SectionsTest::belongToViews() {
  Sample s;
  View view;
  view.name = "cut";
  View same = view;
  view.sections = std::vector{through({1, 0, 0}, 0)};
  QVERIFY(!(view == same));
  same.sections = view.sections;
  QVERIFY(view == same);
  same.sections->front().plane.offset = 1.0f;
  QVERIFY(!(view == same));
}

}  // namespace sline::model

SLINE_TEST_WITH_EVENTS(sline::model::SectionsTest)
#include "sections_test.moc"
