// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "widgets/session/session.h"
#include "widgets/window/window_actions.h"

class QDockWidget;
class QMainWindow;

namespace sline::widgets {

class Presentation;
class Viewport;
class ViewsPanel;
class ViewTour;

/// Saved views in the window: their panel along the lower edge of the picture and what the actions
/// do with them. The panel is there while the scene has views, unless somebody says otherwise of
/// this document.
class TourActions : public QObject {
  Q_OBJECT
 public:
  TourActions(QMainWindow& window, Session& session, Viewport& viewport,
              const WindowActions& actions, QObject* parent);

  ViewTour& tour() { return *m_tour; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeDock(QMainWindow& window, Viewport& viewport);
  void documentChange(const Document& before, const Document& now);
  void showState();

  Session& m_session;
  QAction& m_add;
  QAction& m_present;
  ViewTour* m_tour;
  Presentation* m_presentation;
  ViewsPanel* m_panel = nullptr;
  QDockWidget* m_dock = nullptr;
  std::optional<bool> m_wanted;  ///< the panel, as somebody said
};

}  // namespace sline::widgets
