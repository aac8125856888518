// SPDX-License-Identifier: Apache-2.0
// Tests that a picture that one looks at for a while comes again with more samples, and makes way
// at once for all else.
#include <QSignalSpy>
#include <QtTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "model/edit/look.h"
#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// What a painter is told, and what became of it.
struct Watch {
  std::atomic<bool> waits = false;  ///< refining goes on until it is unwanted
  std::atomic<int> begun = 0;
  std::atomic<int> abandoned = 0;
  std::atomic<int> done = 0;
};

class WatchedPainter : public widgets::PicturePainter {
 public:
  WatchedPainter(std::unique_ptr<widgets::PicturePainter> painter, std::shared_ptr<Watch> watch)
      : m_painter(std::move(painter)), m_watch(std::move(watch)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    return m_painter->paint(request, job);
  }
  Result<bool> refine(const widgets::PictureRequest& request,
                      const render::Picture::TargetJob& job) override {
    ++m_watch->begun;
    while (m_watch->waits && !*job.unwanted)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const Result<bool> done = m_painter->refine(request, job);
    ++(done && *done ? m_watch->done : m_watch->abandoned);
    return done;
  }
  int layersDrawn() const override { return m_painter->layersDrawn(); }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<Watch> m_watch;
};

double apart(QRgb a, QRgb b) {
  return std::hypot(qRed(a) - qRed(b), qGreen(a) - qGreen(b), qBlue(a) - qBlue(b));
}

/// Returns the mean difference of a channel, 0 … 255.
double meanApart(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      sum += apart(a.pixel(x, y), b.pixel(x, y)) / std::sqrt(3.0);
  return sum / (double(a.width()) * a.height());
}

}  // namespace

class ViewportRefinementTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;
  static constexpr int longWait = 30'000;

  static void setGamma(WindowFixture& f, const std::vector<model::NodeId>& ids, float gamma) {
    f.session.apply(QStringLiteral("Γ"),
                    model::withLook(f.session.scene(), ids, {.gamma = Gamma::clamped(gamma)}));
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void aPictureAtRestComesFiner() {
    const auto watch = std::make_shared<Watch>();
    watch->waits = true;
    WindowFixture f(rendererBehind<WatchedPainter>(watch));
    widgets::chooseRefinement(true);
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    f.session.select({f.session.scene().named("left kidney").front()});
    setGamma(f, f.session.scene().structuresBelow(model::rootId), 5.0f);
    QVERIFY(f.settled());
    const QImage plain = f.picture();
    QTRY_VERIFY_WITH_TIMEOUT(watch->begun > 0, longWait);
    QCOMPARE(f.picture(), plain);
    // What was painted last may still be waiting to be told.
    QCoreApplication::processEvents();
    const QSignalSpy shown(&f.viewport(), &widgets::Viewport::pictureShown);
    const int before = watch->done;
    watch->waits = false;
    QTRY_VERIFY_WITH_TIMEOUT(watch->done > before, longWait);
    QTRY_VERIFY_WITH_TIMEOUT(f.picture() != plain, longWait);
    const QImage fine = f.picture();
    QCOMPARE(fine.size(), plain.size());
    const double mean = meanApart(fine, plain);
    qInfo("mean difference %.3f", mean);
    QVERIFY(mean > 0.0 && mean < 2.0);
    // It is the same picture: nobody is told of another one, and it stays.
    QVERIFY(f.viewport().upToDate());
    QTest::qWait(1500);
    QCOMPARE(f.picture(), fine);
    QCOMPARE(shown.count(), 0);
    QCOMPARE(watch->done.load(), before + 1);
  }

  void movingOnGivesItUp() {
    const auto watch = std::make_shared<Watch>();
    watch->waits = true;
    WindowFixture f(rendererBehind<WatchedPainter>(watch));
    widgets::chooseRefinement(true);
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    for (int round = 0; round < 3; ++round) {
      QTRY_VERIFY_WITH_TIMEOUT(watch->begun > watch->abandoned, longWait);
      const int abandoned = watch->abandoned;
      f.viewport().setFocus();
      QTest::keyClick(&f.viewport(), Qt::Key_Right);
      QVERIFY(f.settled());
      QTRY_VERIFY(watch->abandoned > abandoned);
    }
    QCOMPARE(watch->done.load(), 0);
    const QImage plain = f.picture();
    watch->waits = false;
    QTRY_VERIFY_WITH_TIMEOUT(watch->done == 1, longWait);
    QTRY_VERIFY_WITH_TIMEOUT(f.picture() != plain, longWait);
  }

  /// What is kept of the layers stays, so that the next change draws one layer.
  void layersAreKept() {
    const auto watch = std::make_shared<Watch>();
    WindowFixture f(rendererBehind<WatchedPainter>(watch));
    widgets::chooseRefinement(true);
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QTRY_VERIFY_WITH_TIMEOUT(watch->done > 0, longWait);
    const int done = watch->done;
    const model::NodeId id = f.session.scene().named("left kidney").front();
    setGamma(f, {id}, 1.0f);
    QVERIFY(f.settled());
    QCOMPARE(f.viewport().lastLayersDrawn(), 1);
    const QImage plain = f.picture();
    QTRY_VERIFY_WITH_TIMEOUT(watch->done > done, longWait);
    QTRY_VERIFY_WITH_TIMEOUT(f.picture() != plain, longWait);
  }

  void cleanup() { widgets::chooseRefinement(false); }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewportRefinementTest)
#include "viewport_refinement_test.moc"
