// SPDX-License-Identifier: Apache-2.0
// Tests that a picture comes back when graphics go: the context, the memory, or whatever is thrown.
#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScopeGuard>
#include <QtTest>
#include <stdexcept>

#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// A painter that fails as many times as it is told to, as a driver does that lost its context.
class FailingPainter : public widgets::PicturePainter {
 public:
  FailingPainter(std::unique_ptr<widgets::PicturePainter> painter,
                 std::shared_ptr<std::atomic<int>> failures)
      : m_painter(std::move(painter)), m_failures(std::move(failures)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    if (*m_failures > 0) {
      --*m_failures;
      return Error{.reason = "the context was lost", .remedy = "Update the graphics driver"};
    }
    return m_painter->paint(request, job);
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<std::atomic<int>> m_failures;
};

/// A painter that asks its driver for more memory than any has, as often as it is told to.
class GreedyPainter : public widgets::PicturePainter {
 public:
  GreedyPainter(std::unique_ptr<widgets::PicturePainter> painter,
                std::shared_ptr<std::atomic<int>> times)
      : m_painter(std::move(painter)), m_times(std::move(times)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    if (*m_times > 0) {
      --*m_times;
      QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
      GLuint buffer = 0;
      gl.glGenBuffers(1, &buffer);
      gl.glBindBuffer(GL_ARRAY_BUFFER, buffer);
      gl.glBufferData(GL_ARRAY_BUFFER, qopengl_GLsizeiptr(1) << 50, nullptr, GL_STATIC_DRAW);
      gl.glDeleteBuffers(1, &buffer);
    }
    return m_painter->paint(request, job);
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<std::atomic<int>> m_times;
};

/// What a painter throws, and how often; what it does otherwise.
struct Throws {
  enum class At { nowhere, making, drawing, gettingReady, refining };
  std::atomic<At> at = At::nowhere;
  std::atomic<bool> known = true;  ///< an exception of the library's
  std::atomic<int> thrown = 0;

  void maybe(At here) {
    if (at != here)
      return;
    ++thrown;
    if (known)
      throw std::runtime_error("of no use");
    throw 42;
  }
};

/// A painter that throws where it is told to.
class ThrowingPainter : public widgets::PicturePainter {
 public:
  ThrowingPainter(std::unique_ptr<widgets::PicturePainter> painter, std::shared_ptr<Throws> throws)
      : m_painter(std::move(painter)), m_throws(std::move(throws)) {
    m_throws->maybe(Throws::At::making);
  }
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    m_throws->maybe(Throws::At::drawing);
    m_throws->maybe(Throws::At::making);  // only then is a painter made anew
    return m_painter->paint(request, job);
  }
  Result<bool> refine(const widgets::PictureRequest& request,
                      const render::Picture::TargetJob& job) override {
    m_throws->maybe(Throws::At::refining);
    return m_painter->refine(request, job);
  }
  void makeReady(const widgets::PictureRequest& request,
                 const std::atomic<bool>& unwanted) override {
    m_throws->maybe(Throws::At::gettingReady);
    m_painter->makeReady(request, unwanted);
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<Throws> m_throws;
};

widgets::PainterFactory failing(const std::shared_ptr<std::atomic<int>>& failures,
                                const std::shared_ptr<std::atomic<int>>& made) {
  return [failures, made]() -> Result<std::unique_ptr<widgets::PicturePainter>> {
    ++*made;
    auto painter = widgets::makePicturePainter();
    if (!painter)
      return painter.error();
    return std::unique_ptr<widgets::PicturePainter>(
        std::make_unique<FailingPainter>(std::move(*painter), failures));
  };
}

}  // namespace

class LostGraphicsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void lostContextIsMadeAnew() {
    const auto failures = std::make_shared<std::atomic<int>>(0);
    const auto made = std::make_shared<std::atomic<int>>(0);
    WindowFixture f(failing(failures, made));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QImage before = f.picture();
    const int first = *made;
    *failures = 1;
    f.viewport().setBackground(render::Background::dark);
    f.viewport().setBackground(render::Background::paper);
    QTRY_COMPARE(made->load(), first + 1);
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
    QVERIFY(!f.control<QWidget>("messageText").isVisible());

    // A renderer that fails again and again gives a message, and the last picture stays.
    *failures = 1000;
    QSignalSpy failed(&f.viewport(), &widgets::Viewport::failed);
    QTest::keyClick(&f.window, Qt::Key_L);
    QTRY_VERIFY(!failed.isEmpty());
    QTRY_VERIFY(f.control<QWidget>("messageText").isVisible());
    QVERIFY(made->load() <= first + 3);
    *failures = 0;
    QTest::keyClick(&f.window, Qt::Key_A);
    QVERIFY(f.settled());
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
  }

  /// However often a picture is asked for meanwhile, graphics that have ended are made anew once.
  void aRestartIsAskedForOnce() {
    const auto refused = std::make_shared<std::atomic<bool>>(false);
    const auto failures = std::make_shared<std::atomic<int>>(0);
    const auto made = std::make_shared<std::atomic<int>>(0);
    WindowFixture f([=, make = failing(failures, made)]() {
      auto painter = make();
      if (*refused)
        painter = Error{.reason = "there is no context", .remedy = "Try again"};
      return painter;
    });
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    *refused = true;
    *failures = 1;
    f.viewport().setBackground(render::Background::dark);
    QTRY_VERIFY(f.control<QWidget>("messageText").isVisible());
    QTest::qWait(200);  // until the thread has ended
    const int first = *made;
    *refused = false;
    for (const render::Background ground :
         {render::Background::paper, render::Background::white, render::Background::paper})
      f.viewport().setBackground(ground);
    QVERIFY(f.settled());
    QCOMPARE(made->load(), first + 1);
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
  }

  /// What a driver only tells when it is asked is no picture: it is drawn anew, and told where that
  /// does not help.
  void aFullDriverIsNoticed() {
    const auto times = std::make_shared<std::atomic<int>>(0);
    const auto usual = qScopeGuard([] {
      if (qEnvironmentVariable("SLINE_TEST_SCREEN") != QStringLiteral("driver"))
        widgets::chooseScreens(widgets::ScreenKind::automatic);
    });
    widgets::chooseScreens(widgets::ScreenKind::driver);  // else nothing of OpenGL is opened
    WindowFixture f(rendererBehind<GreedyPainter>(times));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QImage before = f.picture();
    *times = 1;
    f.viewport().setBackground(render::Background::dark);
    QTRY_COMPARE(times->load(), 0);
    f.viewport().setBackground(render::Background::paper);
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
    *times = 1000;
    f.viewport().setBackground(render::Background::dark);
    QTRY_VERIFY(f.control<QWidget>("messageText").isVisible());
    QVERIFY(f.control<QLabel>("messageText").text().contains("no memory left"));
    *times = 0;
    f.viewport().setBackground(render::Background::paper);
    QVERIFY(f.settled());
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
  }

  void whatIsThrownIsSurvived_data() {
    QTest::addColumn<int>("at");
    QTest::addColumn<bool>("known");
    QTest::addColumn<bool>("told");
    using At = Throws::At;
    QTest::newRow("drawing") << int(At::drawing) << true << true;
    QTest::newRow("drawing, and nobody knows what") << int(At::drawing) << false << true;
    QTest::newRow("getting ready") << int(At::gettingReady) << true << false;
    QTest::newRow("getting ready, unknown") << int(At::gettingReady) << false << false;
    QTest::newRow("refining, unknown") << int(At::refining) << false << false;
    QTest::newRow("making a painter") << int(At::making) << true << true;
  }
  /// A picture that cannot be drawn costs nothing but itself: the document can be edited, undone
  /// and drawn again.
  void whatIsThrownIsSurvived() {
    QFETCH(int, at);
    QFETCH(bool, known);
    QFETCH(bool, told);
    const auto throws = std::make_shared<Throws>();
    WindowFixture f(rendererBehind<ThrowingPainter>(throws));
    widgets::chooseRefinement(Throws::At(at) == Throws::At::refining);
    const auto usual = qScopeGuard([] { widgets::chooseRefinement(false); });
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QImage before = f.picture();
    throws->known = known;
    throws->at = Throws::At(at);
    f.viewport().setBackground(render::Background::dark);
    QTRY_VERIFY(throws->thrown > 0);
    if (told)
      QTRY_VERIFY(f.control<QWidget>("messageText").isVisible());
    else
      QVERIFY(f.settled());
    QCOMPARE(f.control<QWidget>("messageText").isVisible(), told);
    // The document is as it was, and can be edited.
    QTest::keyClick(&f.window, Qt::Key_K);
    QVERIFY(f.session.modified());
    f.session.undo();
    throws->at = Throws::At::nowhere;
    f.viewport().setBackground(render::Background::paper);
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LostGraphicsTest)
#include "lost_graphics_test.moc"
