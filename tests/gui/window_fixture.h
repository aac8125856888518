// SPDX-License-Identifier: Apache-2.0
// Provides the window with settings of its own in a temporary folder, and helpers that operate it.
#pragma once

#include <QEvent>
#include <QImage>
#include <QSettings>
#include <QTemporaryDir>
#include <QWidget>
#include <functional>
#include <memory>

#include "widgets/structure_tree/structure_tree_view.h"
#include "widgets/viewport/viewport.h"
#include "widgets/window/main_window.h"

namespace sline::test {

/// Returns the path of the settings file in that folder; what a crash leaves goes there, too.
QString sealed(const QString& folder);

class WindowFixture {
 public:
  /// Shows an empty window; the painter, if given, draws in place of the renderer.
  explicit WindowFixture(widgets::PainterFactory painter = {});

  widgets::Session session;
  QTemporaryDir folder;
  QSettings settings;
  widgets::MainWindow window;

  widgets::Viewport& viewport() { return window.viewport(); }
  widgets::StructureTreeView& tree();
  /// Returns the control of that name; fails the test loudly if there is none.
  template <class T>
  T& control(const char* name) {
    T* found = window.findChild<T*>(QLatin1String(name));
    if (!found)
      qFatal("no control %s", name);
    return *found;
  }

  /// Drags the path onto the window and drops it; returns false if the window does not take it.
  bool drop(const QString& path, Qt::KeyboardModifiers keys = {});
  /// Waits until nothing is being opened and the picture shows all as it is; returns false after a
  /// minute.
  bool settled();
  /// Returns what is on screen in the picture's place.
  QImage picture();
  /// Returns the pixels of the picture that the structure can touch, strokes included.
  QRect areaOf(model::NodeId id);
  /// Drags the row's inline slider from where it stands to Γ; the button stays down.
  void pullGamma(model::NodeId id, float to);
  void letGoOfGamma();
};

/// Presses, moves a few times and releases.
void dragMouse(QWidget& widget, const QPoint& from, const QPoint& to,
               Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});
/// Makes a system drag from one place of the widget to another: it runs an event loop of its own,
/// and what the hand does next comes from within. `beforeRelease` runs there, just before the
/// button is released. Returns false if no drag began or it hung.
bool dragAndDrop(QWidget& widget, const QPoint& from, const QPoint& to,
                 const std::function<void()>& beforeRelease = {});
void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at,
               Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});

/// Returns the smallest rectangle around all pixels that differ; empty if none does.
QRect difference(const QImage& a, const QImage& b);

/// Writes six spheres and tori, "left kidney" and the like in two folders, as mesh files.
void writeBody(const QString& folder);

}  // namespace sline::test
