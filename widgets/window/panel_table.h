// SPDX-License-Identifier: Apache-2.0
// The panels around the picture as a table: docks, the menu of panels and their help are made from
// it.
#pragma once

#include <QString>
#include <functional>
#include <vector>

class QMainWindow;
class QSettings;
class QWidget;

namespace sline::widgets {

class FocusContext;
class Preferences;
class Session;
class Viewport;
class ViewTour;
class WindowActions;

/// What a panel may need of the window.
struct PanelPlace {
  Session& session;
  QSettings& settings;
  Preferences& preferences;
  Viewport& viewport;
  FocusContext& focus;
  ViewTour& tour;
  const WindowActions& actions;
};

struct PanelRow {
  const char* id;  ///< the dock's objectName: settings and help know it by that
  QString title;
  Qt::DockWidgetArea area;
  const char* beside;  ///< the panel whose tab it is behind; empty: it stands for itself
  bool shown;          ///< until somebody says otherwise
  std::function<QWidget*(const PanelPlace&)> make;
};

/// In the order in which they stand.
std::vector<PanelRow> panelRows();

/// Gives the window a dock for each row.
void addPanels(QMainWindow& window, const PanelPlace& place);

}  // namespace sline::widgets
