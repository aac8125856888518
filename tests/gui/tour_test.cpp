// SPDX-License-Identifier: Apache-2.0
// Tests going to saved views, with and without a transition, and presenting them.
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>

#include "tests/gui/views_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

class TourTest : public QObject {
  Q_OBJECT

 private slots:
  void goingThere();
  void goingThereByEnter();
  void goingThereByTheMenu();
  void transition();
  void interruptedByHand();
  void editedMeanwhile();
  void presentation();
  void presentationGivesAllBack();
  void presentationLeavesTheSceneAlone();
  void presentationEndsWithTheDocument();
};

void TourTest::goingThere() {
  Views f;
  f.addThree();
  f.setGamma(f.left, 5.0f);
  const int steps = f.steps();
  const model::Scene before = f.scene();
  f.clickCard(0);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 2.0f);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(f.settled());
  // Undo brings the looks back; the camera stays, as turning is no edit.
  f.undo();
  QVERIFY(f.scene() == before);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  // If only the camera differs there is no step.
  f.session.redo();
  f.clickCard(2);
  QVERIFY(f.viewport().camera() == f.scene().views()[2].camera);
  QCOMPARE(f.steps(), steps + 1);
}

void TourTest::goingThereByEnter() {
  Views f;
  f.addThree();
  f.row().setCurrentIndex(f.row().model()->index(2, 0));
  QTest::keyClick(&f.row(), Qt::Key_Home);
  QCOMPARE(f.row().currentIndex().row(), 0);
  QVERIFY(!(f.viewport().camera() == f.scene().views()[0].camera));
  QTest::keyClick(&f.row(), Qt::Key_Return);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
}

void TourTest::goingThereByTheMenu() {
  Views f;
  f.addThree();
  f.control<QMenu>("savedViews").actions()[1]->trigger();
  QVERIFY(f.viewport().camera() == f.scene().views()[1].camera);
  QCOMPARE(f.row().currentIndex().row(), 1);
}

void TourTest::transition() {
  Views f;
  QVERIFY(f.addFrontAndBack());
  f.clickCard(0);
  QVERIFY(f.settled());
  f.fly();
  QList<glm::vec3> eyes;
  connect(&f.viewport(), &widgets::Viewport::cameraChanged, &f.viewport(),
          [&] { eyes << f.viewport().camera().eye; });
  f.clickCard(1);
  QVERIFY(!f.viewport().upToDate());
  // The document changes at once, while the picture is on its way.
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 5.0f);
  QVERIFY(f.settled());
  QVERIFY(f.viewport().camera() == f.scene().views()[1].camera);
  QVERIFY2(eyes.size() >= 2, qPrintable(QString::number(eyes.size())));
  // The camera flies on an arc, never nearer than both ends.
  const model::Camera end = f.viewport().camera();
  const float distance = glm::length(end.eye - end.target);
  for (const glm::vec3& eye : eyes)
    QVERIFY(glm::length(eye - end.target) > 0.8f * distance);
  const QImage flown = f.picture();
  f.viewport().setFlights(false);
  f.clickCard(0);
  QVERIFY(f.settled());
  f.clickCard(1);
  QVERIFY(f.settled());
  QCOMPARE(difference(flown, f.picture()), QRect());
}

void TourTest::interruptedByHand() {
  Views f;
  QVERIFY(f.addFrontAndBack());
  f.fly();
  f.clickCard(0);
  QVERIFY(!f.viewport().upToDate());
  dragMouse(f.viewport(), {300, 300}, {340, 300});
  const model::Camera stopped = f.viewport().camera();
  QVERIFY(f.settled());
  QVERIFY(f.viewport().camera() == stopped);
  QVERIFY(!(stopped == f.scene().views()[0].camera));
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 2.0f);
  // The picture shows the document, not a state on the way.
  const QImage picture = f.picture();
  f.viewport().setFlights(false);
  f.viewport().setCamera(f.scene().views()[0].camera);
  QVERIFY(f.settled());
  f.viewport().setCamera(stopped);
  QVERIFY(f.settled());
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void TourTest::editedMeanwhile() {
  Views f;
  QVERIFY(f.addFrontAndBack());
  f.fly();
  f.clickCard(0);
  f.undo();
  QVERIFY(f.settled());
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 5.0f);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  const QImage picture = f.picture();
  f.session.redo();
  QVERIFY(f.settled());
  f.session.undo();
  QVERIFY(f.settled());
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void TourTest::presentation() {
  Views f;
  f.addThree();
  f.clickCard(1);
  QVERIFY(f.settled());
  QTest::keyClick(&f.viewport(), Qt::Key_F5, Qt::ShiftModifier);
  QCOMPARE(f.presented(), QString("2 / 3   View 2"));
  QVERIFY(f.window.isFullScreen());
  QVERIFY(!f.window.menuBar()->isVisible() && !f.window.statusBar()->isVisible());
  for (QDockWidget* dock : f.window.findChildren<QDockWidget*>())
    QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
  const struct {
    Qt::Key key;
    int at;
  } rows[] = {{Qt::Key_Right, 3},     {Qt::Key_Right, 3},  {Qt::Key_Left, 2},
              {Qt::Key_Home, 1},      {Qt::Key_Up, 1},     {Qt::Key_Space, 2},
              {Qt::Key_PageDown, 3},  {Qt::Key_PageUp, 2}, {Qt::Key_End, 3},
              {Qt::Key_Backspace, 2}, {Qt::Key_Return, 3}};
  for (const auto& row : rows) {
    QTest::keyClick(&f.viewport(), row.key);
    QCOMPARE(f.presented(), QString("%1 / 3   View %1").arg(row.at));
    QVERIFY(f.viewport().camera() == f.scene().views()[std::size_t(row.at - 1)].camera);
  }
  // The mouse turns the scene.
  dragMouse(f.viewport(), {300, 300}, {360, 300});
  QVERIFY(!(f.viewport().camera() == f.scene().views()[2].camera));
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QCOMPARE(f.presented(), QString());
  // Picture and card are where the presentation began: updating the view changes nothing.
  QVERIFY(f.viewport().camera() == f.scene().views()[1].camera);
  QCOMPARE(f.row().currentIndex().row(), 1);
  const model::Scene before = f.scene();
  const int steps = f.steps();
  f.press("viewUpdate");
  QVERIFY(f.scene() == before && f.steps() == steps);
}

void TourTest::presentationGivesAllBack() {
  Views f;
  f.addThree();
  QTest::keyClick(&f.viewport(), Qt::Key_Plus);
  QTest::keyClick(&f.window, Qt::Key_1, Qt::ControlModifier);
  QVERIFY(f.settled());
  const model::Camera camera = f.viewport().camera();
  const QRect place = f.window.geometry();
  QStringList before;
  const auto visible = [&] {
    QStringList names;
    for (QWidget* widget : f.window.findChildren<QWidget*>())
      if (widget->isVisible() && !widget->objectName().isEmpty())
        names << widget->objectName();
    names.sort();
    return names;
  };
  before = visible();
  const QImage picture = f.picture();
  QVERIFY(f.session.activeSection());
  f.control<QAction>("present").trigger();
  QVERIFY(f.settled());
  QVERIFY(!f.session.activeSection());
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(!f.window.isFullScreen());
  QTRY_COMPARE(f.window.geometry(), place);
  QVERIFY(f.settled());
  QVERIFY(f.session.activeSection());
  QVERIFY(f.viewport().camera() == camera);
  QCOMPARE(visible(), before);
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void TourTest::presentationLeavesTheSceneAlone() {
  Views f;
  f.addThree();
  f.setGamma(f.left, 5.0f);
  f.session.select({f.left});
  QVERIFY(f.settled());
  const QImage edited = f.picture();
  const model::Scene before = f.scene();
  const int steps = f.steps();
  f.control<QAction>("present").trigger();
  QVERIFY(f.settled());
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_F, Qt::Key_Slash, Qt::Key_K, Qt::Key_X})
    QTest::keyClick(&f.viewport(), key);
  QTest::keyClick(&f.viewport(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(&f.viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, f.viewport().rect().center());
  QTest::mouseClick(&f.viewport(), Qt::RightButton, {}, f.viewport().rect().center());
  QVERIFY(f.settled());
  QVERIFY(f.scene() == before && f.steps() == steps);
  QCOMPARE(f.session.selection(), widgets::NodeIds{f.left});
  QVERIFY(!QApplication::activePopupWidget());
  // The picture shows the view nevertheless, with all at Γ 2.
  QCOMPARE(f.viewport().shownScene().resolve(f.left).gamma.value(), 2.0f);
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(f.settled());
  QCOMPARE(difference(edited, f.picture()), QRect());
}

void TourTest::presentationEndsWithTheDocument() {
  Views f;
  f.addThree();
  f.control<QAction>("present").trigger();
  QVERIFY(!f.presented().isEmpty());
  f.session.openEmpty(QStringLiteral("another"));
  QVERIFY(f.presented().isEmpty());
  QVERIFY(!f.window.isFullScreen());
  QVERIFY(f.window.menuBar()->isVisible());
}

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TourTest)
#include "tour_test.moc"
