// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>

#include "model/scene_file/autosave.h"
#include "widgets/session/autosaver.h"
#include "widgets/session/recent_files.h"
#include "widgets/session/scene_saver.h"
#include "widgets/session/session.h"

class QMainWindow;
class QMenu;
class QProgressBar;
class QSettings;

namespace sline::widgets {

class MessageBar;
class Preferences;
class Viewport;
class WindowActions;
struct DemoScene;

using PathsHandler = std::function<void(const QStringList&)>;

/// What the actions of files do: opening, saving, closing, what a crash has left; and the window's
/// title, which says what is open and whether it is saved. Whatever would let go of unsaved changes
/// asks first.
class FileActions : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Session& session;
    QSettings& settings;
    Preferences& preferences;
    const WindowActions& actions;
    MessageBar& message;
    Viewport& viewport;
  };
  /// All parts must outlive it.
  FileActions(const Parts& parts, QMainWindow& window);

  /// The window's actions and menus are others now.
  void controlsRemade();

  /// Who decides what becomes of files that are dropped or chosen where there may be a choice; a
  /// scene file alone is opened, and so is everything until it is said.
  void setDropHandler(PathsHandler handler) { m_dropHandler = std::move(handler); }
  void dropped(const QStringList& paths);

  void open(const QStringList& paths);
  void openRecent(const QString& path);
  void openDemo(const DemoScene& demo);
  void recover(const model::Recoverable& found);
  /// The copy is removed for good.
  void forget(const model::Recoverable& found);
  /// Calls it now, or when what is unsaved was saved or given up; or never.
  void whenSafe(const std::function<void()>& then);

  RecentFiles& recent() { return m_recent; }
  /// What crashes have left, the newest first.
  const std::vector<model::Recoverable>& recoverable() const { return m_recoverable; }

  /// False where something is to be asked or written first; the window is closed afterwards.
  bool mayClose();
  /// The window closes.
  void letGo();

 signals:
  void recoverableChanged();

 private:
  void connectActions();
  void connectSaver();
  void save();
  void saveAs(SceneSaver::As as);
  void saveTo(const QString& path, SceneSaver::As as);
  void fileChange();
  void fillRecent(QMenu& menu);
  void offerRecovery();
  QString lastFolder() const;
  QString suggestedPath() const;

  Session& m_session;
  QSettings& m_settings;
  Preferences& m_preferences;
  const WindowActions& m_actions;
  MessageBar& m_message;
  Viewport& m_viewport;
  QMainWindow& m_window;
  RecentFiles m_recent;
  SceneSaver m_saver;
  Autosaver m_autosaver;
  BackgroundQueue m_seeker;
  std::vector<model::Recoverable> m_recoverable;
  PathsHandler m_dropHandler;
  std::function<void()> m_afterSaving;
  QPointer<QProgressBar> m_saving;  ///< in the status bar, while something is written
  bool m_closing = false;           ///< asked, and answered
};

}  // namespace sline::widgets
