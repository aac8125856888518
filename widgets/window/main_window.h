// SPDX-License-Identifier: Apache-2.0
// The workstation's window: puts the controls together and passes on what they ask for.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <optional>
#include <vector>

#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"
#include "widgets/shell/menu_table.h"
#include "widgets/shell/window_actions.h"

class QLabel;
class QProgressBar;
class QSettings;
class QToolButton;

namespace sline::widgets {

class ExportActions;
class FileActions;
class FocusContext;
struct HandedFiles;
class ImportActions;
class MessageBar;
class SectionActions;
class StartPage;
class StructureTree;
class ViewActions;
class ViewTour;
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
  FileActions& files() { return *m_files; }
  FocusContext& focus() { return *m_focus; }

  /// Whether nothing is asked that must be answered first.
  bool isFree() const;
  /// Files that another start of the program hands over: as if they were dropped, and the window
  /// comes to the front.
  void take(const HandedFiles& files);

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeCentre();
  /// All but the centre.
  void makeControls();
  /// Again, in the language of now.
  void remakeControls();
  void nameStructures();
  void makePanels();
  /// As wide and high as they are at first.
  void sizePanels();
  void makeStatus();
  void makeMenus();
  void makeTools();
  void connectSession();
  void connectActions();
  void connectViews();
  void restore();
  void showHelp();
  void makeFiles();
  void makeExports();
  void makeStart();
  void makeImports();
  /// The start page while nothing is open and nothing is on its way.
  void showStart();
  void placeMessage(bool onStartPage);
  void openDropped(const QStringList& paths, Qt::KeyboardModifiers keys);
  void documentChange(const Document& before, const Document& now);
  void updateActions();
  void jobShown(bool running);

  Session& m_session;
  QSettings& m_settings;
  Preferences m_preferences;
  WindowActions m_actions;
  std::optional<WindowMenus> m_menus;
  bool m_sized = false;        ///< panels have been given their sizes
  QObject* m_parts = nullptr;  ///< what belongs to the controls, and goes with them
  MessageBar* m_message = nullptr;
  Viewport* m_viewport = nullptr;
  FileActions* m_files = nullptr;
  ExportActions* m_exports = nullptr;
  StartPage* m_start = nullptr;
  StructureTree* m_tree = nullptr;
  FocusContext* m_focus = nullptr;
  ImportActions* m_imports = nullptr;
  SectionActions* m_sections = nullptr;
  ViewActions* m_views = nullptr;
  ViewTour* m_tour = nullptr;
  QLabel* m_summary = nullptr;
  QLabel* m_job = nullptr;
  QProgressBar* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
};

}  // namespace sline::widgets
