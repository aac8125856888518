// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>

#include "model/scene_file/journal.h"
#include "widgets/session/journaler.h"
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

/// Runs the actions of files: opening, saving, closing, recovering what a crash has left; and sets
/// the window's title, which says what is open and whether it is saved. Every action that would
/// discard unsaved changes asks first.
class FileActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    Session& session;
    QSettings& settings;
    Preferences& preferences;
    const WindowActions& actions;
    MessageBar& message;
    Viewport& viewport;
  };
  /// Connects the parts, all of which must outlive it.
  FileActions(const Context& context, QMainWindow& window);

  /// Connects to the window's new actions and menus after they have been replaced.
  void controlsRemade();

  /// Sets the handler of files that are dropped or chosen where there may be a choice; a lone scene
  /// file is opened, and so are all files until a handler is set.
  void setDropHandler(PathsHandler handler) { m_dropHandler = std::move(handler); }
  void dropped(const QStringList& paths);

  void open(const QStringList& paths);
  void openRecent(const QString& path);
  void openDemo(const DemoScene& demo);
  void recover(const model::Recoverable& found);
  /// Removes the journal for good.
  void forget(const model::Recoverable& found);
  /// Calls the function now, or once unsaved changes were saved or discarded, or never.
  void whenSafe(const std::function<void()>& then);

  RecentFiles& recent() { return m_recent; }
  /// Returns what crashes have left, the newest first.
  const std::vector<model::Recoverable>& recoverable() const { return m_recoverable; }

  /// Returns false where a question or a save must come first; the window is closed afterwards.
  bool mayClose();
  /// Discards the journal of unsaved work, because the window closes.
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
  Journaler m_journaler;
  BackgroundQueue m_seeker;
  std::vector<model::Recoverable> m_recoverable;
  PathsHandler m_dropHandler;
  std::function<void()> m_afterSaving;
  QPointer<QProgressBar> m_saving;  ///< in the status bar, while something is written
  // What was said to have failed, until it succeeds.
  std::optional<Error> m_notSaved;
  std::optional<Error> m_notKept;
  bool m_closing = false;  ///< the question was asked and answered
};

}  // namespace sline::widgets
