// SPDX-License-Identifier: Apache-2.0
// Tests that the window answers at once, whatever is done and however large the scene: no event is
// much work for the window's thread, and none waits for the renderer. Milliseconds are told by
// sline-bench-window.
#include <QAbstractButton>
#include <QMessageBox>
#include <QtTest>

#include "tests/gui/event_watch.h"
#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

namespace {

constexpr std::uint64_t limit = 400'000;  // requests for memory in one event

WatchedApplication& watch() {
  return *static_cast<WatchedApplication*>(QCoreApplication::instance());
}

/// Returns 40 groups of 25 small structures.
Result<widgets::LoadedDocument> crowd(const model::ImportProgress&, const std::stop_token&) {
  model::Scene scene;
  for (int g = 0; g < 40; ++g) {
    const model::NodeId group = scene.append({.name = "Group " + std::to_string(g)});
    for (int s = 0; s < 25; ++s)
      scene.append(
          {.parent = group,
           .name = "Ball " + std::to_string(25 * g + s),
           .style = {.colour = Colour{200, 160, 120}},
           .mesh = moved(*sphere(3.0f, 2), 1.0f, {8.0f * float(s), 0.0f, 8.0f * float(g)})});
  }
  return widgets::LoadedDocument{
      .scene = std::move(scene), .title = QStringLiteral("Crowd"), .remarks = {}};
}

}  // namespace

/// Acts as a user at work; between gestures there is time for the window to draw itself.
struct Hands {
  WindowFixture& f;

  void orbit() {
    const QPoint middle = f.viewport().rect().center();
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    for (int i = 1; i <= 60; ++i) {
      sendMouse(f.viewport(), QEvent::MouseMove, middle + QPoint(7 * i, i));
      QTest::qWait(16);
    }
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle);
  }
  void dragGamma(model::NodeId id) {
    for (int i = 0; i < 6; ++i) {
      f.pullGamma(id, i % 2 == 0 ? 4.5f : 0.5f);
      QTest::qWait(50);
      f.letGoOfGamma();
    }
  }
  void key(QWidget& where, Qt::Key key, Qt::KeyboardModifiers with = {}) {
    QTest::keyClick(&where, key, with);
    QTest::qWait(20);
  }
  void undoAndRedo() {
    for (int i = 0; i < 8; ++i)
      key(f.window, Qt::Key_Z, Qt::ControlModifier);
    for (int i = 0; i < 8; ++i)
      key(f.window, Qt::Key_Y, Qt::ControlModifier);
  }
  void workTheTree() {
    f.tree().setFocus();
    key(f.tree(), Qt::Key_A, Qt::ControlModifier);
    for (const Qt::Key k : {Qt::Key_Space, Qt::Key_Space, Qt::Key_Home, Qt::Key_Left, Qt::Key_Right,
                            Qt::Key_Down, Qt::Key_Down, Qt::Key_Down})
      key(f.tree(), k);
    key(f.window, Qt::Key_E, Qt::ControlModifier);
    key(f.window, Qt::Key_D, Qt::ControlModifier);
  }
  void resize() {
    for (int i = 0; i < 20; ++i) {
      f.window.resize(1200 - 20 * i, 800 - 10 * i);
      QTest::qWait(30);
    }
  }
};

class EventCostTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static bool affordable(const char* gesture) {
    const std::uint64_t most = watch().mostRequests();
    qInfo().noquote() << gesture << watch().report(3);
    watch().forget();
    return most < limit;
  }
  static model::NodeId lastStructure(const WindowFixture& f) {
    return f.session.scene().structuresBelow(model::rootId).back();
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void noEventIsMuchWork_data() {
    QTest::addColumn<QString>("scene");
    QTest::newRow("demo") << "demo-pelvis-female";
    QTest::newRow("atlas") << SLINE_TEST_DATA
        "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
    QTest::newRow("a thousand structures") << "crowd";
  }
  void noEventIsMuchWork() {
    QFETCH(QString, scene);
    const bool file = scene.startsWith(QLatin1Char('/'));
    if (file && !QFileInfo::exists(scene))
      SLINE_ABSENT("no real anatomy here");
    WindowFixture f;
    Hands hands{f};
    watch().forget();
    if (file)
      QVERIFY(f.drop(scene));
    else if (scene == QLatin1String("crowd"))
      f.session.openMade(scene, crowd);
    else
      f.window.findChild<QAction*>(scene)->trigger();
    QVERIFY(f.settled());
    QVERIFY(affordable("opening"));
    hands.orbit();
    QVERIFY(affordable("orbit"));
    hands.dragGamma(lastStructure(f));
    QVERIFY(affordable("gamma of a structure"));
    hands.dragGamma(f.session.scene().nodes().front().id);
    QVERIFY(affordable("gamma of a group"));
    hands.undoAndRedo();
    QVERIFY(affordable("undo and redo"));
    hands.workTheTree();
    QVERIFY(affordable("tree"));
    hands.resize();
    QVERIFY(affordable("resize"));
    f.session.openMade(QStringLiteral("crowd"), crowd);
    QVERIFY(f.settled());
    hands.key(f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.settled());
    QVERIFY(affordable("another document and back"));
  }

  /// The renderer stands in the middle of a picture until all is done: an event that waited for it
  /// would wait for ever.
  void noEventWaitsForThePicture() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    Hands hands{f};
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    gate->open = false;
    f.viewport().setBackground(render::Background::dark);
    QTRY_COMPARE(gate->begun.load(), gate->done.load() + 1);
    const int done = gate->done;
    hands.orbit();
    hands.dragGamma(lastStructure(f));
    hands.dragGamma(f.session.scene().nodes().front().id);
    hands.undoAndRedo();
    hands.workTheTree();
    hands.resize();
    QVERIFY(f.drop(m_body.path() + QStringLiteral("/Vessels")));
    auto& unsaved = f.control<QMessageBox>("unsavedDialog");
    QTest::mouseClick(unsaved.button(QMessageBox::Discard), Qt::LeftButton);
    QTRY_COMPARE(f.session.scene().structuresBelow(model::rootId).size(), std::size_t(2));
    hands.key(f.window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(gate->done.load(), done);
    gate->open = true;
    gate->pass.release();
    QVERIFY(f.settled());
  }
};

}  // namespace sline::test

SLINE_ENROL(sline::test::runSuiteIn<sline::test::EventCostTest, sline::test::WatchedApplication>)
#include "event_cost_test.moc"
