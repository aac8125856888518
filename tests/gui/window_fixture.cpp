// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/window_fixture.h"

#include <QApplication>
#include <QDir>
#include <QDrag>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QTimer>
#include <QWindow>
#include <QtTest>
#include <cmath>

#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "widgets/focus/focus_context.h"
#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_model.h"
#include "widgets/viewport/picture_screen.h"
#include "widgets/viewport/render_thread.h"

namespace sline::test {

QString sealed(const QString& folder) {
  qputenv("XDG_STATE_HOME", QFile::encodeName(folder + QStringLiteral("/state")));
  const QString file = folder + QStringLiteral("/settings.ini");
  QSettings settings(file, QSettings::IniFormat);
  // No demo is modelled in the background, where it would interfere.
  settings.setValue(QStringLiteral("start/demoPictures"), false);
  // What is opened looks as it is, at once and for good; opening_look_test says otherwise.
  settings.setValue(QStringLiteral("picture/openingLook"), QStringLiteral("plain"));
  // Views change at once, so that a test finds the next one when the key was pressed.
  settings.setValue(QStringLiteral("navigation/flights"), false);
  // A picture that is done stays as it is; viewport_refinement_test says otherwise.
  widgets::chooseRefinement(false);
  if (qEnvironmentVariable("SLINE_TEST_SCREEN") == QStringLiteral("driver"))
    widgets::chooseScreens(widgets::ScreenKind::driver);
  return file;
}

WindowFixture::WindowFixture(widgets::PainterFactory painter)
    : settings(sealed(folder.path()), QSettings::IniFormat), window(session, settings) {
  if (painter)
    viewport().setPainter(std::move(painter));
  window.resize(1200, 800);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window))
    qFatal("the window does not show");
  // A bare display has no window manager to do this.
  QApplication::setActiveWindow(&window);
}

widgets::StructureTreeView& WindowFixture::tree() {
  return window.tree().view();
}

bool WindowFixture::drop(const QString& path, Qt::KeyboardModifiers keys) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPoint at = window.rect().center();
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, keys);
  QApplication::sendEvent(&window, &enter);
  if (!enter.isAccepted())
    return false;
  QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, keys);
  QApplication::sendEvent(&window, &drop);
  return drop.isAccepted();
}

bool WindowFixture::settled() {
  constexpr int minute = 60'000;
  return QTest::qWaitFor(
      [this] { return !session.busy() && !window.focus().busy() && viewport().upToDate(); },
      minute);
}

QImage WindowFixture::picture() {
  return viewport().picture().convertToFormat(QImage::Format_RGB32);
}

QRect WindowFixture::areaOf(model::NodeId id) {
  const model::Camera& camera = viewport().camera();
  const QSizeF size = viewport().size();
  const auto aspect = float(size.width() / size.height());
  const glm::mat4 matrix =
      model::projectionMatrix(camera, session.scene().visibleBounds(), aspect) *
      model::viewMatrix(camera);
  double left = size.width();
  double top = size.height();
  double right = 0.0;
  double bottom = 0.0;
  for (const model::NodeId structure : session.scene().structuresBelow(id))
    for (const glm::vec3& p : session.scene().find(structure)->mesh->positions()) {
      const glm::vec4 clip = matrix * glm::vec4(p, 1.0f);
      const double x = 0.5 * (1.0 + double(clip.x / clip.w)) * size.width();
      const double y = 0.5 * (1.0 - double(clip.y / clip.w)) * size.height();
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  constexpr double pen = 2.0;  // λ: strokes are two wide and centred a little outside
  const double margin = std::ceil(pen * size.height() / 720.0) + 1.0;
  return QRectF(QPointF(left - margin, top - margin), QPointF(right + margin, bottom + margin))
      .toAlignedRect();
}

void WindowFixture::pullGamma(model::NodeId id, float to) {
  tree().scrollTo(tree().indexOf(id));
  const auto cell = [&] {
    return widgets::GammaCell{QRectF(tree().cellOf(id, widgets::StructureTreeModel::gamma))};
  };
  const double from = cell().xOf(session.scene().resolve(id).gamma);
  const double target = cell().xOf(Gamma::clamped(to));
  const double y = cell().groove().center().y();
  QWidget& canvas = *tree().viewport();
  sendMouse(canvas, QEvent::MouseButtonPress, {from, y});
  for (int step = 1; step <= 5; ++step)
    sendMouse(canvas, QEvent::MouseMove, {from + (target - from) * step / 5.0, y});
}

void WindowFixture::letGoOfGamma() {
  sendMouse(*tree().viewport(), QEvent::MouseButtonRelease, {});
}

bool dragAndDrop(QWidget& widget, const QPoint& from, const QPoint& to,
                 const std::function<void()>& beforeRelease) {
  constexpr int released = 7;
  constexpr int hung = 100;
  QWindow* window = widget.window()->windowHandle();
  const auto inWindow = [&](const QPoint& at) { return widget.mapTo(widget.window(), at); };
  int step = 0;
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &widget, [&] {
    ++step;
    if (step < 6)
      QTest::mouseMove(window, inWindow(from + (to - from) * step / 5));
    else if (step == 6 && beforeRelease)
      beforeRelease();
    else if (step == released)
      QTest::mouseRelease(window, Qt::LeftButton, {}, inWindow(to));
    else if (step > hung)
      QDrag::cancel();
  });
  QTest::mousePress(window, Qt::LeftButton, {}, inWindow(from));
  QTest::mouseMove(window, inWindow(from + QPoint(2, 1)));
  hand.start(10);
  QTest::mouseMove(window, inWindow(from + QPoint(24, 4)));  // returns when the drag is over
  hand.stop();
  if (step == 0)
    QTest::mouseRelease(window, Qt::LeftButton, {}, inWindow(from));
  return step > 0 && step <= hung;
}

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::KeyboardModifiers keys) {
  const bool move = type == QEvent::MouseMove;
  const Qt::MouseButtons down =
      type == QEvent::MouseButtonRelease ? Qt::MouseButtons() : Qt::MouseButtons(button);
  QMouseEvent event(type, at, widget.mapToGlobal(at), move ? Qt::NoButton : button, down, keys);
  QApplication::sendEvent(&widget, &event);
}

void dragMouse(QWidget& widget, const QPoint& from, const QPoint& to, Qt::MouseButton button,
               Qt::KeyboardModifiers keys) {
  constexpr int steps = 6;
  sendMouse(widget, QEvent::MouseButtonPress, from, button, keys);
  for (int step = 1; step <= steps; ++step)
    sendMouse(widget, QEvent::MouseMove, from + QPointF(to - from) * step / steps, button, keys);
  sendMouse(widget, QEvent::MouseButtonRelease, to, button, keys);
}

QRect difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size())
    return QRect(QPoint(), a.size().expandedTo(b.size()));
  QRect area;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y))
        area |= QRect(x, y, 1, 1);
  return area;
}

void writeBody(const QString& folder) {
  struct Part {
    const char* file;
    model::MeshPtr mesh;
    glm::vec3 place;
  };
  const model::MeshPtr ball = sphere(20.0f, 4);
  const model::MeshPtr ring = torus(22.0f, 8.0f, 64, 24);
  const Part parts[] = {{"Organs/left kidney", ball, {60.0f, 0.0f, 0.0f}},
                        {"Organs/right kidney", ball, {-60.0f, 0.0f, 0.0f}},
                        {"Organs/bladder", ball, {0.0f, -10.0f, -80.0f}},
                        {"Vessels/aorta", ring, {0.0f, 0.0f, 30.0f}},
                        {"Vessels/left renal vein", ring, {20.0f, 15.0f, -20.0f}}};
  for (const Part& part : parts) {
    const QString path = folder + QLatin1Char('/') + QLatin1String(part.file);
    QDir().mkpath(QFileInfo(path).path());
    writeMesh(path + QStringLiteral(".ply"), *moved(*part.mesh, 1.0f, part.place));
  }
}

}  // namespace sline::test
