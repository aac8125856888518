// SPDX-License-Identifier: Apache-2.0
// Tests that the window never waits for a picture, and shows the newest there is.
#include <QDirIterator>
#include <QLabel>
#include <QtTest>

#include "model/edit/emphasis.h"
#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

namespace {

/// A Heart beats each time the event loop comes round.
class Heart : public QObject {
 public:
  Heart() { startTimer(1); }
  int beats() const { return m_beats; }

 protected:
  void timerEvent(QTimerEvent*) override { ++m_beats; }

 private:
  int m_beats = 0;
};

}  // namespace

class WaitingTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  /// While the renderer stands still, everything else in the window goes on; of all pictures wanted
  /// meanwhile only the last is drawn.
  void windowLivesWhileTheRendererStands() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const model::NodeId id = f.session.scene().named("bladder").front();
    const QImage before = f.picture();

    gate->open = false;
    const int doneBefore = gate->done;
    const int begunBefore = gate->begun;
    f.pullGamma(id, 4.0f);
    QTRY_COMPARE(gate->begun.load(), begunBefore + 1);
    Heart heart;
    constexpr int drags = 20;
    for (int i = 0; i < drags; ++i) {
      f.pullGamma(id, i % 2 == 0 ? 1.0f : 4.0f);
      f.letGoOfGamma();
      const int beat = heart.beats();
      QTRY_VERIFY(heart.beats() > beat);
      // The tree follows at once, the window repaints, and the picture is the last that was
      // finished.
      const float shown =
          f.tree().indexOf(id).data(widgets::StructureTreeModel::lowGammaRole).toFloat();
      QCOMPARE(shown, i % 2 == 0 ? 1.0f : 4.0f);
      QCOMPARE(difference(before, f.picture()), QRect());
    }
    QCOMPARE(gate->done.load(), doneBefore);
    QVERIFY(!f.viewport().upToDate());

    gate->open = true;
    gate->pass.release();
    QVERIFY(f.settled());
    QCOMPARE(gate->done.load(), doneBefore + 2);
    QVERIFY(!difference(before, f.picture()).isEmpty());
  }

  /// Outdated cameras are skipped in the same way; the newest wins.
  void outdatedPicturesAreSkipped() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    gate->open = false;
    const int begun = gate->begun;
    const QPoint middle = f.viewport().rect().center();
    dragMouse(f.viewport(), middle, middle + QPoint(30, 0));
    QTRY_COMPARE(gate->begun.load(), begun + 1);
    for (int i = 0; i < 30; ++i)
      dragMouse(f.viewport(), middle, middle + QPoint(10 * (i % 3 + 2), 20));
    const std::uint64_t held = gate->last;
    gate->open = true;
    gate->pass.release();
    QVERIFY(f.settled());
    QVERIFY2(gate->begun <= begun + 4, "outdated pictures were drawn");
    QVERIFY(gate->last >= held + 30);
  }

  /// The camera follows a drag once for each picture and ends where the mouse does, even if no
  /// picture comes for long.
  void aDragGoesOnWithThePictures() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QPoint middle = f.viewport().rect().center();
    const auto goTo = [&](int x) {
      sendMouse(f.viewport(), QEvent::MouseMove, middle + QPoint(x, 0));
      return f.viewport().camera();
    };
    // This is where the camera goes when nothing holds it back.
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    const model::Camera begun = f.viewport().camera();
    goTo(90);
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle + QPoint(90, 0));
    const model::Camera wanted = f.viewport().camera();
    f.viewport().setCamera(begun);
    QVERIFY(f.settled());

    gate->open = false;
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    const model::Camera first = goTo(30);
    QVERIFY(first != begun);
    QCOMPARE(goTo(60), first);
    QCOMPARE(goTo(90), first);
    gate->open = true;
    gate->pass.release();
    QTRY_COMPARE(f.viewport().camera(), wanted);
    QVERIFY(f.settled());

    gate->open = false;
    const model::Camera second = goTo(50);
    QVERIFY(second != wanted);
    QTest::qWait(350);
    QVERIFY(goTo(20) != second);
    goTo(90);
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle + QPoint(90, 0));
    const model::Camera released = f.viewport().camera();
    gate->open = true;
    gate->pass.release();
    QCOMPARE(released, wanted);
    QVERIFY(f.settled());
  }

  /// Letters at the edges are those of the picture on screen until the next document's picture is
  /// there.
  void marksBelongToTheirPicture() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    const auto letters = [&f] {
      QStringList all;
      for (const char* name : {"letterLeft", "letterRight", "letterTop", "letterBottom"})
        if (f.control<QLabel>(name).isVisible())
          all << f.control<QLabel>(name).text();
      return all;
    };
    gate->open = false;
    QVERIFY(f.drop(m_body.path()));
    QTRY_VERIFY(f.session.document().opening != 0);
    QCOMPARE(letters(), QStringList());
    gate->open = true;
    gate->pass.release(2);
    QVERIFY(f.settled());
    QCOMPARE(letters().size(), qsizetype(4));
    QTest::keyClick(&f.viewport(), Qt::Key_S);
    QVERIFY(f.settled());
    // Another document is seen from the front, and so is the first when it comes back.
    for (const bool back : {false, true}) {
      const QStringList before = letters();
      gate->pass.tryAcquire(gate->pass.available());
      gate->open = false;
      if (back)
        f.session.undo();
      else
        QVERIFY(f.drop(m_body.path() + QStringLiteral("/Vessels")));
      QTRY_VERIFY(!f.session.busy());
      QCoreApplication::processEvents();
      // Nothing of the document before stays on screen, its marks neither.
      QCOMPARE(letters(), QStringList());
      gate->open = true;
      gate->pass.release(4);
      QVERIFY(f.settled());
      QVERIFY(letters() != before);
      QTest::keyClick(&f.viewport(), Qt::Key_S);
      QVERIFY(f.settled());
    }
  }

  /// Where all pictures of a move are overtaken by the one at rest, the letters are those of that.
  void marksFollowAPictureAtRest() {
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const auto& left = f.control<QLabel>("letterLeft");
    QCOMPARE(left.text(), QString("R"));
    gate->pass.tryAcquire(gate->pass.available());
    gate->open = false;
    const int begun = gate->begun;
    f.viewport().setBackground(render::Background::dark);
    QTRY_COMPARE(gate->begun.load(), begun + 1);
    QTest::keyClick(&f.viewport(), Qt::Key_P);
    QTest::qWait(1000);  // until the camera rests
    gate->open = true;
    gate->pass.release();
    QVERIFY(f.settled());
    QCOMPARE(gate->begun.load(), begun + 2);
    QCOMPARE(left.text(), QString("L"));
  }

  /// A window that closes while the renderer is at work is torn down in order.
  void closesWhileDrawing() {
    const auto gate = std::make_shared<Gate>();
    auto f = std::make_unique<WindowFixture>(gated(gate));
    QVERIFY(f->drop(m_body.path()));
    QVERIFY(f->settled());
    gate->open = false;
    f->viewport().setBackground(render::Background::dark);
    QTRY_COMPARE(gate->begun.load(), gate->done.load() + 1);
    QTimer::singleShot(50, [gate] { gate->pass.release(); });
    gate->pass.release();
    f.reset();
    QCOMPARE(gate->begun.load(), gate->done.load());
  }

  /// A window that closes while a demo is modelled does not wait for its end either: it never gets
  /// as far as the cache.
  void closesWhileModelling_data() {
    QTest::addColumn<QString>("demo");
    QTest::addColumn<int>("after");
    for (const int after : {0, 200, 700}) {
      QTest::addRow("pelvis, %d ms", after) << "demo-pelvis-male" << after;
      QTest::addRow("abdomen, %d ms", after) << "demo-abdomen-male" << after;
    }
  }
  void closesWhileModelling() {
    QFETCH(QString, demo);
    QFETCH(int, after);
    const QTemporaryDir cache;
    qputenv("XDG_CACHE_HOME", cache.path().toLocal8Bit());
    auto f = std::make_unique<WindowFixture>();
    f->window.findChild<QAction*>(demo)->trigger();
    QTest::qWait(after);
    QVERIFY(f->session.busy());
    f->window.close();
    QVERIFY(!f->window.isVisible());
    f.reset();
    QDirIterator files(cache.path(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext())
      QVERIFY2(!files.next().endsWith(QStringLiteral(".scene")), "it was modelled to the end");
    qunsetenv("XDG_CACHE_HOME");
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::WaitingTest)
#include "waiting_test.moc"
