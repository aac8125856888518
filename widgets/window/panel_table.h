// SPDX-License-Identifier: Apache-2.0
// Lists the panels around the picture as a table, from which docks, the menu of panels and their
// help are made.
#pragma once

#include <QByteArray>
#include <QString>
#include <functional>
#include <vector>

class QMainWindow;
class QSettings;
class QWidget;

namespace sline::widgets {

class FocusContext;
class NearTool;
class Preferences;
class Session;
class Viewport;
class ViewTour;
class WindowActions;

/// Holds what a panel may need of the window.
struct PanelContext {
  Session& session;
  QSettings& settings;
  Preferences& preferences;
  Viewport& viewport;
  FocusContext& focus;
  NearTool& nearness;
  ViewTour& tour;
  const WindowActions& actions;
};

struct PanelRow {
  const char* id;  ///< the dock's objectName, by which settings and help know it
  QString title;
  Qt::DockWidgetArea area;
  const char* beside;  ///< the panel behind which it is a tab; empty if it stands alone
  bool shown;          ///< until the user shows or hides it
  std::function<QWidget*(const PanelContext&)> make;
};

/// Returns the panels in the order in which they stand.
std::vector<PanelRow> panelRows();

/// Gives the window a dock for each row.
void addPanels(QMainWindow& window, const PanelContext& context);

/// Hides all panels at once and brings those back that were there.
class HiddenPanels {
 public:
  void toggle(QMainWindow& window);

 private:
  QByteArray m_shown;  ///< as QMainWindow::saveState has it
};

}  // namespace sline::widgets
