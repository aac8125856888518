// SPDX-License-Identifier: Apache-2.0
// The window with settings of its own in a temporary folder, and hands to work it.
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

/// Where settings lie, in that folder; what a crash leaves goes there, too.
QString sealed(const QString& folder);

class WindowFixture {
 public:
  /// Shows an empty window; the painter, where given, draws in place of the renderer.
  explicit WindowFixture(widgets::PainterFactory painter = {});

  widgets::Session session;
  QTemporaryDir folder;
  QSettings settings;
  widgets::MainWindow window;

  widgets::Viewport& viewport() { return window.viewport(); }
  widgets::StructureTreeView& tree();
  /// Fails the test loudly where there is no such control.
  template <class T>
  T& control(const char* name) {
    T* found = window.findChild<T*>(QLatin1String(name));
    if (!found)
      qFatal("no control %s", name);
    return *found;
  }

  /// Drags the path onto the window and lets it go; false where the window does not take it.
  bool drop(const QString& path, Qt::KeyboardModifiers keys = {});
  /// Until nothing is being opened and the picture is of all as it is; false after a minute.
  bool settled();
  /// What is on screen in the picture's place.
  QImage picture();
  /// The pixels of the picture that the structure can touch, strokes included.
  QRect areaOf(model::NodeId id);
  /// Drags the row's inline slider from where it stands to Γ; the button stays down.
  void pullGamma(model::NodeId id, float to);
  void letGoOfGamma();
};

/// Press, a few moves, release.
void dragMouse(QWidget& widget, const QPoint& from, const QPoint& to,
               Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});
/// A drag of the system's from one place of the widget to another: it runs an event loop of its
/// own, and what the hand does next comes from within. `beforeRelease` happens there, just before
/// the hand lets go. False where no drag began or it hung.
bool dragAndDrop(QWidget& widget, const QPoint& from, const QPoint& to,
                 const std::function<void()>& beforeRelease = {});
void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at,
               Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});

/// The smallest rectangle around all pixels that differ; empty where none does.
QRect difference(const QImage& a, const QImage& b);

/// Six spheres and tori, "left kidney" and the like in two folders, as mesh files.
void writeBody(const QString& folder);

}  // namespace sline::test
