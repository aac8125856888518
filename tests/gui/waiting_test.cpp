// SPDX-License-Identifier: Apache-2.0
// The window never waits for a picture: with a renderer that is held up, and with a slow one.
#include <QElapsedTimer>
#include <QSemaphore>
#include <QtTest>
#include <atomic>

#include "model/edit/emphasis.h"
#include "tests/gui/window_fixture.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

namespace {

/// What happens on the render thread, seen and steered from outside.
struct Gate {
  QSemaphore pass;  ///< one for each picture that may begin
  std::atomic<bool> open = true;
  std::atomic<int> begun = 0;
  std::atomic<int> done = 0;
  std::atomic<std::uint64_t> last = 0;  ///< number of the last request that was begun
};

/// The renderer behind a gate.
class GatedPainter : public widgets::PicturePainter {
 public:
  GatedPainter(std::unique_ptr<widgets::PicturePainter> painter, std::shared_ptr<Gate> gate)
      : m_painter(std::move(painter)), m_gate(std::move(gate)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    m_gate->last = request.number;
    ++m_gate->begun;
    if (!m_gate->open)
      m_gate->pass.acquire();
    const Result<bool> painted = m_painter->paint(request, job);
    ++m_gate->done;
    return painted;
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<Gate> m_gate;
};

widgets::PainterFactory gated(const std::shared_ptr<Gate>& gate) {
  return [gate]() -> Result<std::unique_ptr<widgets::PicturePainter>> {
    auto painter = widgets::makePicturePainter();
    if (!painter)
      return painter.error();
    return std::unique_ptr<widgets::PicturePainter>(
        std::make_unique<GatedPainter>(std::move(*painter), gate));
  };
}

/// Beats as often as the event loop comes round and remembers the longest pause.
class Heart : public QObject {
 public:
  Heart() {
    m_clock.start();
    startTimer(1);
  }
  int beats() const { return m_beats; }
  double longestPause() const { return m_longest; }  ///< milliseconds
  void forget() { m_longest = 0.0; }

 protected:
  void timerEvent(QTimerEvent*) override {
    const double pause = double(m_clock.nsecsElapsed()) * 1e-6;
    m_clock.restart();
    m_longest = std::max(m_longest, pause);
    ++m_beats;
  }

 private:
  QElapsedTimer m_clock;
  int m_beats = 0;
  double m_longest = 0.0;
};

}  // namespace

class WaitingTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  /// While the renderer stands still, everything else in the window goes on; of all that was asked
  /// for meanwhile only the last is drawn.
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
      // The tree follows at once, the window repaints, the picture is the last that was finished.
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

  /// The same with the camera; the newest wins.
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
    QVERIFY(gate->last > held + 100);
  }

  /// A window that closes while the renderer is at work comes down in order.
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

  /// What a person feels with real anatomy and the real renderer. Pauses have many causes on a
  /// shared machine, so the figure is reported and only held against the pictures themselves: if
  /// the window waited for them, its pauses would be as long.
  void turningRealAnatomy() {
    const QString abdomen = QStringLiteral(SLINE_TEST_DATA "/abdomen");
    if (!QFileInfo::exists(abdomen))
      QSKIP("no real anatomy here");
    WindowFixture f;
    QVERIFY(f.drop(
        QDir(abdomen).filePath(QDir(abdomen).entryList({QStringLiteral("*.mrml")}).value(0))));
    QVERIFY(f.settled());
    Heart heart;
    double longestPicture = 0.0;
    int pictures = 0;
    QObject::connect(&f.viewport(), &widgets::Viewport::pictureShown, &heart, [&] {
      longestPicture = std::max(longestPicture, f.viewport().lastMilliseconds());
      ++pictures;
    });
    const QPoint middle = f.viewport().rect().center();
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    QElapsedTimer clock;
    clock.start();
    for (int x = 0; clock.elapsed() < 4000; x += 3) {
      sendMouse(f.viewport(), QEvent::MouseMove, middle + QPoint(x, x / 7));
      const int beat = heart.beats();
      QVERIFY(QTest::qWaitFor([&] { return heart.beats() > beat + 4; }));
    }
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle);
    QVERIFY(f.settled());
    qInfo(
        "%d pictures while turning, the longest took %.0f ms; longest pause of the event loop "
        "%.0f ms",
        pictures, longestPicture, heart.longestPause());
    QVERIFY(pictures > 2);
    QVERIFY(heart.longestPause() < std::max(100.0, 0.5 * longestPicture));
  }
};

}  // namespace sline::test

QTEST_MAIN(sline::test::WaitingTest)
#include "waiting_test.moc"
