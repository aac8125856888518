// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

class QDockWidget;
class QMainWindow;

namespace sline::widgets {

class Presentation;
class Viewport;
class ViewsPanel;
class ViewTour;

/// Manages saved views in the window: their panel along the lower edge of the picture and the
/// actions on them. The panel is shown while the scene has views, unless the user has shown or
/// hidden it for this document.
class TourActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    QMainWindow& window;
    Session& session;
    Viewport& viewport;
    const WindowActions& actions;
    ViewTour& tour;
    QDockWidget& dock;
    ViewsPanel& panel;
  };
  TourActions(const Context& context, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void documentChange(const Document& before, const Document& now);
  void showState();

  Session& m_session;
  QAction& m_add;
  QAction& m_present;
  ViewTour& m_tour;
  Presentation* m_presentation;
  ViewsPanel& m_panel;
  QDockWidget& m_dock;
  std::optional<bool> m_wanted;  ///< the user's choice about the panel
};

}  // namespace sline::widgets
