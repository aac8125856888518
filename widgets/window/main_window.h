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
#include "widgets/window/panel_table.h"

class QLabel;
class QProgressBar;
class QSettings;
class QToolButton;

namespace sline::widgets {

class BrushTool;
class ComparisonActions;
class FigureActions;
class ExportActions;
class FileActions;
class FocusContext;
struct HandedFiles;
class ImportActions;
class MessageBar;
class NearTool;
class SectionActions;
class StartPage;
class StructureTree;
class ViewActions;
class ViewTour;
class Viewport;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// Makes the window. The settings remember its shape, the background and the last folder; they
  /// must outlive the window.
  MainWindow(Session& session, QSettings& settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  Viewport& viewport() { return *m_viewport; }
  StructureTree& tree() { return *m_tree; }
  Preferences& preferences() { return m_preferences; }
  FileActions& files() { return *m_files; }
  FocusContext& focus() { return *m_focus; }
  BrushTool& brush() { return *m_brush; }
  NearTool& nearness() { return *m_nearness; }

  /// Tells whether no question is open that must be answered first.
  bool isFree() const;
  /// Takes files that another start of the program hands over: they are treated as dropped, and the
  /// window comes to the front.
  void take(const HandedFiles& files);

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeCentre();
  /// Makes all controls except the centre.
  void makeControls();
  /// Makes them again, in the current language.
  void remakeControls();
  void nameStructures();
  void makePanels();
  /// Gives the panels their initial width and height.
  void sizePanels();
  void makeStatus();
  void makeMenus();
  void makeTools();
  void connectSession();
  float pictureAspect() const;
  void connectActions();
  void connectViews();
  void restore();
  void showHelp();
  void makeFiles();
  void makeExports();
  void makeStart();
  void makeImports();
  /// Shows the start page while nothing is open or being opened.
  void showStart();
  void placeMessage(bool onStartPage);
  /// Says why an edit was not made, until another one is.
  void refuse(const Error& error);
  void openDropped(const QStringList& paths, Qt::KeyboardModifiers keys);
  void documentChange(const Document& before, const Document& now);
  void updateActions();
  void jobShown(bool running);

  Session& m_session;
  QSettings& m_settings;
  Preferences m_preferences;
  WindowActions m_actions;
  HiddenPanels m_hiddenPanels;
  std::optional<WindowMenus> m_menus;
  bool m_sized = false;        ///< panels have been given their sizes
  QObject* m_parts = nullptr;  ///< owns what belongs to the controls, and is deleted with them
  MessageBar* m_message = nullptr;
  std::optional<Error> m_refused;  ///< what the message says of an edit, or has said
  int m_remarkedAt = 0;            ///< the step of the history that was remarked on last
  Viewport* m_viewport = nullptr;
  NearTool* m_nearness = nullptr;  ///< belongs to the viewport, as does the brush
  BrushTool* m_brush = nullptr;
  FileActions* m_files = nullptr;
  ExportActions* m_exports = nullptr;
  ComparisonActions* m_comparisons = nullptr;
  FigureActions* m_figures = nullptr;
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
