// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QLabel>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <optional>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

class QKeyEvent;
class QMainWindow;

namespace sline::widgets {

/// Shows the tour on the whole screen: the picture and the view's name, nothing else. Arrow keys,
/// space, Page Up and Page Down go from view to view, Home and End to the first and last, Escape
/// ends it. The mouse turns the scene, but nothing of the document can be changed; when the
/// presentation ends, the document, the window and the camera are as they were.
class Presentation : public QObject {
  Q_OBJECT
 public:
  Presentation(QMainWindow& window, Session& session, Viewport& viewport, QObject* parent);
  ~Presentation() override;

  /// Begins at that view; does nothing where there are no views.
  void begin(int index);
  void end();
  bool running() const { return m_before.has_value(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Holds the state of the window before the presentation.
  struct Before {
    QByteArray docks;
    Qt::WindowStates states;
    QRect place;
    QWidget* focus = nullptr;
    MarkChoice marks;
    model::Camera camera;
    glm::vec3 pivot{0.0f};
    std::optional<model::SectionId> section;
    int opening = 0;
  };
  void showBars(bool shown);
  void show(int index);
  void key(const QKeyEvent& event);
  void nameView(const model::View& view);
  void placeName();
  void documentChange();

  QMainWindow& m_window;
  Session& m_session;
  Viewport& m_viewport;
  QPointer<QLabel> m_name;  ///< belongs to the viewport
  std::optional<Before> m_before;
  int m_at = 0;
};

}  // namespace sline::widgets
