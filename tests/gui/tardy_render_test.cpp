// SPDX-License-Identifier: Apache-2.0
// Tests that a window of many structures lives through whatever is done with it while the thread
// that draws lags behind. Meant for the sanitizers as well: what one thread holds of another's
// shows only where both are out of step.
#include <QtTest>
#include <array>
#include <mutex>
#include <random>

#include "model/edit/look.h"
#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Says how long the thread that draws waits before and after each thing that it does.
class Delays {
 public:
  void wait() {
    const std::lock_guard lock(m_mutex);
    QThread::msleep(m_range(m_random));
  }

 private:
  std::mutex m_mutex;
  std::mt19937 m_random{50};
  std::uniform_int_distribution<unsigned long> m_range{0, 25};
};

class TardyPainter : public widgets::PicturePainter {
 public:
  TardyPainter(std::unique_ptr<widgets::PicturePainter> painter, std::shared_ptr<Delays> delays)
      : m_painter(std::move(painter)), m_delays(std::move(delays)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    m_delays->wait();
    Result<bool> painted = m_painter->paint(request, job);
    m_delays->wait();
    return painted;
  }
  Result<std::optional<render::Image>> preview(const widgets::PreviewRequest::Preview& preview,
                                               const std::atomic<bool>& unwanted) override {
    m_delays->wait();
    return m_painter->preview(preview, unwanted);
  }
  Result<bool> refine(const widgets::PictureRequest& request,
                      const render::Picture::TargetJob& job) override {
    m_delays->wait();
    return m_painter->refine(request, job);
  }
  void makeReady(const widgets::PictureRequest& request,
                 const std::atomic<bool>& unwanted) override {
    m_delays->wait();
    m_painter->makeReady(request, unwanted);
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<Delays> m_delays;
};

}  // namespace

class TardyRenderTest : public QObject {
  Q_OBJECT

  static constexpr int structures = 63;
  QTemporaryDir m_folder;

  QString half(int which) const { return m_folder.filePath(QStringLiteral("half %1").arg(which)); }

 private slots:
  void initTestCase() {
    const std::array<model::MeshPtr, 3> shapes{sphere(9.0f, 4), torus(8.0f, 3.0f, 48, 20),
                                               cylinder(5.0f, 16.0f, 40, 12)};
    for (int i = 0; i < structures; ++i) {
      const QString folder = half(i % 2);
      QDir().mkpath(folder);
      writeMesh(folder + QStringLiteral("/part %1.ply").arg(i),
                *moved(*shapes[i % 3], 1.0f,
                       {20.0f * float(i % 4), 20.0f * float(i / 4 % 4), 20.0f * float(i / 16)}));
    }
  }

  /// Opens, styles, cuts, flies into, resizes, undoes and closes in an order that chance makes,
  /// always the same, and never waits for a picture but after each round.
  void whateverIsDone() {
    WindowFixture f(rendererBehind<TardyPainter>(std::make_shared<Delays>()));
    widgets::chooseRefinement(true);
    std::mt19937 random(63);
    const auto below = [&random](unsigned n) { return unsigned(random() % n); };
    const auto some = [&] {
      widgets::NodeIds ids;
      for (const model::Node& node : f.session.scene().nodes())
        if (!node.isGroup() && below(3) == 0)
          ids.push_back(node.id);
      return ids;
    };
    const auto style = [&](const model::Style& style) {
      f.session.apply(QStringLiteral("Look"), model::withLook(f.session.scene(), some(), style));
    };
    const std::array<std::function<void()>, 11> acts{
        [&] { f.drop(m_folder.path()); },
        [&] { f.drop(half(int(below(2)))); },
        [&] { style({.gamma = Gamma::clamped(0.1f * float(below(51)))}); },
        [&] { style({.opacity = Opacity::clamped(0.25f * float(below(5)))}); },
        [&] { style({.fill = below(2) == 0 ? model::Fill::none : model::Fill::paper}); },
        [&] { style({.visible = below(2) == 0}); },
        [&] {
          // Close to a structure others are behind the eye, and there a driver draws.
          const model::Box bounds = f.session.scene().visibleBounds();
          if (bounds.empty())
            return;
          model::Camera camera = f.viewport().camera();
          camera.target = bounds.centre();
          camera.eye = bounds.centre() + 0.2f * float(below(4)) * bounds.size();
          f.viewport().travelTo(camera, f.session.scene(), f.session.scene());
        },
        [&] { f.window.resize(900 + 100 * int(below(5)), 700 + 50 * int(below(4))); },
        [&] { f.session.undo(); },
        [&] { f.session.redo(); },
        [&] { QTest::keyClick(&f.window, below(2) == 0 ? Qt::Key_L : Qt::Key_A); }};
    const int rounds = 12;
    for (int round = 0; round < rounds; ++round) {
      for (int i = 0; i < 25; ++i) {
        // A scene is opened less often than worked with.
        acts[below(6) == 0 ? below(2) : 2 + below(acts.size() - 2)]();
        QTest::qWait(int(below(30)));
      }
      QVERIFY(f.drop(m_folder.path()));
      QVERIFY(f.settled());
      QCOMPARE(f.session.scene().structuresBelow(model::rootId).size(), std::size_t(structures));
      QVERIFY(!f.control<QWidget>("messageText").isVisible());
      QImage paper = f.picture();
      paper.fill(f.picture().pixel(0, 0));
      QVERIFY(difference(f.picture(), paper).width() > 80);
    }
    widgets::chooseRefinement(false);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TardyRenderTest)
#include "tardy_render_test.moc"
