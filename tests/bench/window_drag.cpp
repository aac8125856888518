// SPDX-License-Identifier: Apache-2.0
// Runs sline-bench-window, which measures the time from a move of the Γ slider, of the mouse that
// turns, and of a section's arrow to the picture on screen, through the whole window, beside a full
// frame through the same window; how long the window is busy with each step of a stroke of the
// brush; and which events kept its thread at work while the file came in. Needs a display
// (xvfb-run).
#include <QApplication>
#include <QElapsedTimer>
#include <QtTest>
#include <cmath>
#include <iostream>
#include <map>

#include "model/camera/camera_moves.h"
#include "tests/bench/measure.h"
#include "tests/gui/event_watch.h"
#include "tests/gui/window_fixture.h"
#include "widgets/brush/brush_tool.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/sections/section_handles.h"
#include "widgets/viewport/tools/points.h"

using namespace sline;

namespace {

/// Returns the milliseconds until the picture shows what was done.
double shownAfter(test::WindowFixture& f) {
  constexpr int minute = 60'000;
  QElapsedTimer clock;
  clock.start();
  bool shown = f.viewport().upToDate();
  QEventLoop loop;
  const auto look = [&] {
    if (f.viewport().upToDate()) {
      shown = true;
      loop.quit();
    }
  };
  QObject::connect(&f.viewport(), &widgets::Viewport::pictureShown, &loop, look);
  QTimer::singleShot(minute, &loop, [&loop] { loop.quit(); });
  if (!shown)
    loop.exec();
  return double(clock.nsecsElapsed()) * 1e-6;
}

struct Times {
  std::vector<double> steps;
  std::vector<double> full;
  std::vector<double> drawing;  // the time that the renderer's thread took for each step
  int mostLayers = 0;
};

Times drag(test::WindowFixture& f, model::NodeId id) {
  f.session.select({id});
  f.settled();
  auto& slider = f.control<widgets::GammaSlider>("gammaSlider");
  const auto at = [&slider](float gamma) { return slider.pointOf(Gamma::clamped(gamma)); };
  Times times;
  model::Camera camera = f.viewport().camera();
  for (const bool counts : {false, true}) {
    for (int i = 0; i < 4 && counts; ++i) {
      camera.eye.x += 0.5f;
      f.viewport().setCamera(camera);
      times.full.push_back(shownAfter(f));
    }
    test::sendMouse(slider, QEvent::MouseButtonPress, at(0.0f));
    shownAfter(f);
    for (float gamma = 0.15f; gamma < 5.0f; gamma += 0.15f) {
      test::sendMouse(slider, QEvent::MouseMove, at(gamma));
      const double milliseconds = shownAfter(f);
      if (!counts)
        continue;  // strokes are laid the first time
      times.steps.push_back(milliseconds);
      times.drawing.push_back(f.viewport().lastMilliseconds());
      times.mostLayers = std::max(times.mostLayers, f.viewport().lastLayersDrawn());
    }
    test::sendMouse(slider, QEvent::MouseButtonRelease, at(2.0f));
    shownAfter(f);
  }
  return times;
}

/// Drags in the picture to and fro along a line, with the mouse reporting its place 60 times a
/// second, and measures the time from one picture to the next.
void dragInPicture(test::WindowFixture& f, const char* what, QPoint from, glm::vec2 along) {
  constexpr int moves = 300;
  constexpr int half = 100;  // steps of one pixel in one direction
  constexpr int interval = 16;
  std::vector<double> gaps;
  std::vector<double> drawing;
  std::map<std::pair<float, int>, int> fineness;  // pictures by scale and step of the surfaces
  QElapsedTimer clock;
  const QObject listener;
  QObject::connect(&f.viewport(), &widgets::Viewport::pictureShown, &listener, [&] {
    gaps.push_back(double(clock.nsecsElapsed()) * 1e-6);
    clock.start();
    drawing.push_back(f.viewport().lastMilliseconds());
    const render::Fineness& last = f.viewport().lastFineness();
    ++fineness[{last.scale, last.surfaceStep}];
  });
  test::sendMouse(f.viewport(), QEvent::MouseButtonPress, from);
  clock.start();
  QPoint last = from;
  for (int i = 1; i <= moves; ++i) {
    const int step = std::abs((i + half) % (4 * half) - 2 * half) - half;
    last = from +
           QPoint(int(std::lround(float(step) * along.x)), int(std::lround(float(step) * along.y)));
    test::sendMouse(f.viewport(), QEvent::MouseMove, last);
    QTest::qWait(interval);
  }
  QObject::disconnect(&f.viewport(), nullptr, &listener, nullptr);
  test::sendMouse(f.viewport(), QEvent::MouseButtonRelease, last);
  const double fine = shownAfter(f);
  const bench::Spread spread = bench::spreadOf(gaps);
  std::cout << what << ": " << gaps.size() << " pictures, one each " << spread.median
            << " ms (drawing " << bench::spreadOf(drawing).median << "), p95 " << spread.p95
            << " ms; fine after " << fine << " ms;";
  for (const auto& [look, count] : fineness)
    std::cout << ' ' << count << " at " << std::lround(100.0f * look.first)
              << " % size, surfaces at 1/" << look.second;
  std::cout << std::endl;
}

/// Pushes a section through the middle by its arrow.
void dragSection(test::WindowFixture& f, const char* what, Qt::Key key) {
  QTest::keyClick(&f.window, key, Qt::ControlModifier);
  f.settled();
  const model::Section& section = f.session.scene().sections().back();
  const QSizeF size = f.viewport().size();
  const auto handles = widgets::sectionHandles(
      widgets::sectionFrame(section.plane, f.session.scene().visibleBounds(section.scope)),
      f.viewport().camera(), {float(size.width()), float(size.height())});
  if (!handles)
    return;
  dragInPicture(f, what, QPoint(int(handles->slide.x), int(handles->slide.y)),
                glm::normalize(handles->tip - handles->slide));
  f.session.undo();
  f.session.undo();
  f.settled();
}

/// Returns the pixel of the structure's vertex that is nearest to the eye.
QPointF nearestOf(test::WindowFixture& f, model::NodeId id) {
  const model::Camera& camera = f.viewport().camera();
  const auto positions = f.session.scene().find(id)->mesh->positions();
  const glm::vec3 nearest =
      *std::min_element(positions.begin(), positions.end(), [&](const auto& a, const auto& b) {
        return glm::distance(camera.eye, a) < glm::distance(camera.eye, b);
      });
  const glm::vec2 size(float(f.viewport().width()), float(f.viewport().height()));
  return widgets::point(model::pixelOf(camera, nearest, size).value_or(0.5f * size));
}

/// Paints on a structure with a wide brush, after the brush has hovered there.
void paint(test::WindowFixture& f, const char* name, model::NodeId id) {
  constexpr float radius = 200.0f;  // pixels
  constexpr int moves = 100;
  f.session.select({id});
  QTest::keyClick(&f.window, Qt::Key_B, Qt::ShiftModifier);
  widgets::BrushTool& brush = f.window.brush();
  brush.setBrush({.radius = radius});
  f.settled();
  const QPointF start = nearestOf(f, id);
  QElapsedTimer hovering;
  hovering.start();
  while (!brush.lookedAhead()) {
    test::sendMouse(f.viewport(), QEvent::MouseMove, start, Qt::NoButton);
    QTest::qWait(1);
  }
  std::cout << "paint " << name << ": looked ahead after " << double(hovering.nsecsElapsed()) * 1e-6
            << " ms of hovering";
  QElapsedTimer clock;
  clock.start();
  test::sendMouse(f.viewport(), QEvent::MouseButtonPress, start);
  std::cout << ", first step " << double(clock.nsecsElapsed()) * 1e-6 << " ms";
  std::vector<double> steps;
  widgets::Pointer pointer{.size = {float(f.viewport().width()), float(f.viewport().height())}};
  for (int i = 1; i <= moves; ++i) {
    pointer.pixel = {float(start.x()) + 2.0f * float(i), float(start.y()) + 0.5f * float(i)};
    brush.passes(pointer);
    clock.start();
    brush.move(pointer);
    steps.push_back(double(clock.nsecsElapsed()) * 1e-6);
  }
  const bench::Spread spread = bench::spreadOf(steps);
  std::cout << ", others " << spread.median << " ms, p95 " << spread.p95 << " ms" << std::endl;
  test::sendMouse(f.viewport(), QEvent::MouseButtonRelease, start);
  f.session.undo();
  brush.setActive(false);
  f.settled();
}

}  // namespace

int main(int argc, char** argv) {
  test::WatchedApplication application(argc, argv);
  if (argc < 3) {
    std::cerr << "usage: sline-bench-window FILE STRUCTURE…\n";
    return 2;
  }
  test::WindowFixture f;
  f.window.resize(1920, 900);
  if (!f.drop(QString::fromLocal8Bit(argv[1])) || !f.settled())
    return 1;
  std::cout << "opening: " << application.report(5).toStdString() << '\n';
  std::cout << "viewport " << f.viewport().width() << "x" << f.viewport().height() << '\n';
  dragInPicture(f, "turn", {600, 400}, {1.5f, 0.5f});
  f.session.select(f.session.scene().named(argv[2]));
  f.settled();
  dragInPicture(f, "turn with a selection", {600, 400}, {1.5f, 0.5f});
  f.session.select({});
  f.settled();
  QTest::keyClick(&f.window, Qt::Key_L);
  f.settled();
  dragSection(f, "axial section", Qt::Key_3);
  dragSection(f, "coronal section", Qt::Key_2);
  QTest::keyClick(&f.window, Qt::Key_A);
  f.settled();
  for (int i = 2; i < argc; ++i)
    for (const model::NodeId id : f.session.scene().named(argv[i])) {
      const Times times = drag(f, id);
      const double step = bench::spreadOf(times.steps).median;
      const double full = bench::spreadOf(times.full).median;
      std::cout << argv[i] << ": step " << step << " ms (drawing "
                << bench::spreadOf(times.drawing).median << "), full frame " << full
                << " ms, ratio " << step / full << ", layers " << times.mostLayers << std::endl;
      paint(f, argv[i], id);
    }
  return 0;
}
