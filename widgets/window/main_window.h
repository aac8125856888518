// SPDX-License-Identifier: Apache-2.0
// The workstation's window: puts the controls together and passes on what they ask for.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <optional>
#include <vector>

#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"
#include "widgets/window/menu_table.h"
#include "widgets/window/window_actions.h"

class QLabel;
class QMenu;
class QProgressBar;
class QSettings;
class QToolButton;

namespace sline::widgets {

class GammaPanel;
class MessageBar;
class SectionActions;
class StructureTree;
class ViewActions;
class Viewport;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// The settings remember the window's shape, the background and the last folder; they must
  /// outlive the window.
  MainWindow(Session& session, QSettings& settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  Viewport& viewport() { return *m_viewport; }
  StructureTree& tree() { return *m_tree; }
  Preferences& preferences() { return m_preferences; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeCentre();
  void makePanels();
  void makeStatus();
  void makeMenus();
  void makeBackgrounds(QMenu& menu);
  void makeTools();
  void connectSession();
  void connectActions();
  void connectViews();
  void restore();
  void chooseFiles();
  void chooseFolder();
  void openPaths(const QStringList& paths);
  void editSelection(const QString& name,
                     model::Edited (*edit)(const model::Scene&, std::span<const model::NodeId>));
  void documentChange(const Document& before, const Document& now);
  void updateActions();
  void jobShown(bool running);

  Session& m_session;
  QSettings& m_settings;
  Preferences m_preferences;
  WindowActions m_actions;
  std::optional<WindowMenus> m_menus;
  MessageBar* m_message = nullptr;
  Viewport* m_viewport = nullptr;
  StructureTree* m_tree = nullptr;
  GammaPanel* m_gamma = nullptr;
  SectionActions* m_sections = nullptr;
  ViewActions* m_views = nullptr;
  QLabel* m_summary = nullptr;
  QLabel* m_job = nullptr;
  QProgressBar* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
};

}  // namespace sline::widgets
