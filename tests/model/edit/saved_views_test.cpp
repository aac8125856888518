// SPDX-License-Identifier: Apache-2.0
// Tests views of a scene added, updated, renamed, moved and removed.
#include <QtTest>
#include <limits>

#include "model/edit/look.h"
#include "model/edit/views.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

QString namesOf(const Scene& scene) {
  QStringList names;
  for (const View& view : scene.views())
    names << QString::fromStdString(view.name);
  return names.join(QLatin1Char('|'));
}

Scene withNames(const QStringList& names) {
  Scene scene;
  scene.append({.name = "ball", .mesh = test::sphere(10, 2)});
  std::vector<View> views;
  for (const QString& name : names)
    views.push_back({.name = name.toStdString()});
  scene.setViews(std::move(views));
  return scene;
}

}  // namespace

class SavedViewsTest : public QObject {
  Q_OBJECT
 private slots:
  void namesAreFree_data();
  void namesAreFree();
  void moved_data();
  void moved();
  void whatIsSeenComesBack();
  void anUpdateKeepsItsName();
  void whatChangesNothing();
  void removedOnes();
  void absentOnesAreCounted();
};

void SavedViewsTest::namesAreFree_data() {
  QTest::addColumn<QString>("wanted");
  QTest::addColumn<QString>("added");    // empty: not at all
  QTest::addColumn<QString>("renamed");  // the first of the two
  QTest::newRow("new") << "Side"
                       << "Front|Back|Side"
                       << "Side|Back";
  QTest::newRow("blanks") << "  Side \n"
                          << "Front|Back|Side"
                          << "Side|Back";
  QTest::newRow("taken") << "Back"
                         << "Front|Back|Back 2"
                         << "Back 2|Back";
  QTest::newRow("taken, in other letters") << "BACK"
                                           << "Front|Back|BACK 2"
                                           << "BACK 2|Back";
  QTest::newRow("its own") << "Front"
                           << "Front|Back|Front 2"
                           << "Front|Back";
  QTest::newRow("its own, in other letters") << "front"
                                             << "Front|Back|front 2"
                                             << "front|Back";
  QTest::newRow("none") << ""
                        << ""
                        << "Front|Back";
  QTest::newRow("blanks alone") << " \t"
                                << ""
                                << "Front|Back";
  QTest::newRow("code") << "<img src=x>"
                        << "Front|Back|<img src=x>"
                        << "<img src=x>|Back";
}

void SavedViewsTest::namesAreFree() {
  QFETCH(QString, wanted);
  QFETCH(QString, added);
  QFETCH(QString, renamed);
  const Scene scene = withNames({"Front", "Back"});
  const Edited more = withView(scene, {.name = wanted.toStdString()});
  QCOMPARE(more.changed, !added.isEmpty());
  QCOMPARE(namesOf(more.scene), added.isEmpty() ? QString("Front|Back") : added);
  const Edited other = withViewRenamed(scene, 0, wanted.toStdString());
  QCOMPARE(namesOf(other.scene), renamed);
  QCOMPARE(other.changed, renamed != "Front|Back");
}

void SavedViewsTest::moved_data() {
  QTest::addColumn<int>("from");
  QTest::addColumn<int>("to");
  QTest::addColumn<QString>("order");
  QTest::newRow("to the front") << 2 << 0 << "c|a|b|d";
  QTest::newRow("to the end") << 0 << 3 << "b|c|d|a";
  QTest::newRow("beyond the end") << 0 << 99 << "b|c|d|a";
  QTest::newRow("one on") << 1 << 2 << "a|c|b|d";
  QTest::newRow("where it is") << 1 << 1 << "a|b|c|d";
  QTest::newRow("none such") << 4 << 0 << "a|b|c|d";
}

void SavedViewsTest::moved() {
  QFETCH(int, from);
  QFETCH(int, to);
  QFETCH(QString, order);
  const Scene scene = withNames({"a", "b", "c", "d"});
  const Edited edited = withViewMoved(scene, std::size_t(from), std::size_t(to));
  QCOMPARE(namesOf(edited.scene), order);
  QCOMPARE(edited.changed, order != "a|b|c|d");
}

void SavedViewsTest::whatIsSeenComesBack() {
  Scene scene = withNames({});
  const NodeId ball = scene.nodes().front().id;
  scene.appendSection({.name = "s"});
  const AnnotationId pin = scene.appendAnnotation(
      {.kind = AnnotationKind::pin, .anchors = {Anchor(glm::vec3(1, 2, 3))}});
  scene.appendAnnotation(
      {.kind = AnnotationKind::pin, .anchors = {Anchor(glm::vec3(3, 2, 1))}, .visible = false});
  Camera camera;
  camera.eye = {500, 0, 0};
  const View view = viewOf(scene, camera, "all");
  QCOMPARE(*view.annotations, std::vector<AnnotationId>{pin});
  Scene changed =
      withLook(scene, std::array{ball}, {.gamma = Gamma::clamped(5), .visible = false}).scene;
  changed.setSections({});
  std::vector<Annotation> annotations = changed.annotations();
  for (Annotation& each : annotations)
    each.visible = !each.visible;
  changed.setAnnotations(annotations);
  const Scene back = withViewApplied(changed, view).scene;
  QCOMPARE(back.resolve(ball), scene.resolve(ball));
  QCOMPARE(back.sections(), scene.sections());
  QCOMPARE(back.annotations(), scene.annotations());
  QVERIFY(view.camera == camera);
}

void SavedViewsTest::anUpdateKeepsItsName() {
  Scene scene = withNames({"a", "b"});
  std::vector<View> views = scene.views();
  views[1].unread = R"({"later":1})";
  scene.setViews(views);
  Camera camera;
  camera.eye = {0, 700, 0};
  const Edited edited = withViewUpdated(scene, 1, viewOf(scene, camera, "another"));
  QVERIFY(edited.changed);
  QCOMPARE(namesOf(edited.scene), "a|b");
  QVERIFY(edited.scene.views()[1].camera == camera);
  QVERIFY(edited.scene.views()[1].looks.has_value());
  QCOMPARE(edited.scene.views()[1].unread, views[1].unread);
  QVERIFY(edited.scene.views()[0] == views[0]);
  QVERIFY(!withViewUpdated(edited.scene, 1, viewOf(edited.scene, camera, {})).changed);
}

void SavedViewsTest::whatChangesNothing() {
  const Scene scene = withNames({"a"});
  Camera faulty;
  faulty.eye.x = std::numeric_limits<float>::quiet_NaN();
  QVERIFY(!withView(scene, {.name = "b", .camera = faulty}).changed);
  QVERIFY(!withViewUpdated(scene, 0, {.camera = faulty}).changed);
  QVERIFY(!withViewUpdated(scene, 1, {}).changed);
  QVERIFY(!withViewRenamed(scene, 1, "b").changed);
  QVERIFY(!withoutView(scene, 1).changed);
}

void SavedViewsTest::removedOnes() {
  const Scene scene = withNames({"a", "b", "c"});
  QCOMPARE(namesOf(withoutView(scene, 1).scene), "a|c");
  QCOMPARE(namesOf(scene), "a|b|c");  // the value that undo returns to
}

void SavedViewsTest::absentOnesAreCounted() {
  const Scene scene = withNames({});
  View view = viewOf(scene, {}, "v");
  QCOMPARE(absentFrom(scene, view), std::size_t(0));
  view.looks->push_back({.node = {77}});
  view.looks->push_back({.node = {78}});
  view.annotations->push_back({88});
  QCOMPARE(absentFrom(scene, view), std::size_t(3));
  QCOMPARE(absentFrom(scene, {.name = "only a camera"}), std::size_t(0));
}

SLINE_TEST(SavedViewsTest)
#include "saved_views_test.moc"
