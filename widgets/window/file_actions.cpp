// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QProgressBar>
#include <QSettings>
#include <QStatusBar>

#include "widgets/preferences/preferences.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/shell/file_dialogs.h"
#include "widgets/shell/message_bar.h"
#include "widgets/shell/window_actions.h"
#include "widgets/start/recovery_dialog.h"
#include "widgets/text/path_text.h"
#include "widgets/viewport/viewport.h"
#include "widgets/window/saved_camera.h"

namespace sline::widgets {

namespace {

constexpr const char* journalKey = "files/journal";

}  // namespace

FileActions::FileActions(const Context& context, QMainWindow& window)
    : QObject(&window),
      m_session(context.session),
      m_settings(context.settings),
      m_preferences(context.preferences),
      m_actions(context.actions),
      m_message(context.message),
      m_viewport(context.viewport),
      m_window(window),
      m_recent(context.settings),
      m_saver(context.session),
      m_journaler(context.session, model::userJournalFolder()) {
  connectActions();
  connectSaver();
  connect(&m_session, &Session::fileChanged, this, &FileActions::fileChange);
  connect(&m_session, &Session::opened, this,
          [this](const std::vector<std::filesystem::path>& paths) {
            if (const auto camera = cameraIn(m_session.file()))
              m_viewport.setCamera(*camera);
            if (paths.size() == 1)
              m_recent.add(textOf(paths.front()));
          });
  const auto follow = [this] {
    m_journaler.setEnabled(m_preferences.isOn(QLatin1String(journalKey)));
  };
  connect(&m_preferences, &Preferences::changed, this, follow);
  connect(&m_journaler, &Journaler::failed, this, [this](const Error& error) {
    m_notKept = error;
    m_message.showError(error);
  });
  connect(&m_journaler, &Journaler::kept, this, [this] {
    if (const auto error = std::exchange(m_notKept, std::nullopt))
      m_message.hideError(*error);
  });
  follow();
  fileChange();
  m_seeker.add([this, folder = m_journaler.folder()](const std::stop_token&) {
    return [this, found = model::recoverableIn(folder)] {
      m_recoverable = found;
      m_actions[QStringLiteral("recover")].setEnabled(!found.empty());
      emit recoverableChanged();
      // The start page shows it anyway.
      const bool elsewhere = m_session.document().opening != 0 || m_session.busy();
      if (elsewhere && !found.empty())
        offerRecovery();
    };
  });
}

void FileActions::connectActions() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  const auto openThese = [this](const QStringList& paths) { dropped(paths); };
  on("new", [this] { whenSafe([this] { m_session.openEmpty(tr("Untitled")); }); });
  on("openFiles", [=, this] { chooseFiles(m_window, lastFolder(), openThese); });
  on("openFolder", [=, this] { chooseFolder(m_window, lastFolder(), openThese); });
  on("save", [this] { save(); });
  on("saveAs", [this] { saveAs(SceneSaver::As::document); });
  on("saveCopy", [this] { saveAs(SceneSaver::As::copy); });
  on("revert",
     [this] { askAboutReverting(m_window, m_session.title(), [this] { m_session.revert(); }); });
  on("close", [this] { whenSafe([this] { m_session.closeDocument(); }); });
  on("reload", [this] { m_session.reloadSources(); });
  on("recover", [this] { offerRecovery(); });
  on("quit", [this] { m_window.close(); });
  m_actions[QStringLiteral("recover")].setEnabled(!m_recoverable.empty());
  auto& recent = *m_window.findChild<QMenu*>(QStringLiteral("recentMenu"));
  connect(&recent, &QMenu::aboutToShow, this, [this, &recent] { fillRecent(recent); });
  const auto enable = [this, &recent] { recent.setEnabled(!m_recent.paths().isEmpty()); };
  connect(&m_recent, &RecentFiles::changed, &recent, enable);
  enable();
}

void FileActions::controlsRemade() {
  connectActions();
  fileChange();
}

void FileActions::connectSaver() {
  connect(&m_saver, &SceneSaver::started, this, [this](const QString& name) {
    m_window.statusBar()->showMessage(tr("Saving %1…").arg(name));
    if (m_saving)
      return;
    m_saving = new QProgressBar;
    m_saving->setObjectName(QStringLiteral("saveProgress"));
    m_saving->setAccessibleName(tr("Saving %1…").arg(name));
    m_saving->setRange(0, 0);  // the time that a disk takes is unknown
    m_saving->setFixedWidth(120);
    m_window.statusBar()->addPermanentWidget(m_saving);
  });
  connect(&m_saver, &SceneSaver::failed, this, [this](const Error& error) {
    m_afterSaving = nullptr;
    m_window.statusBar()->clearMessage();
    m_notSaved = error;
    m_message.showError(error);
  });
  connect(&m_saver, &SceneSaver::saved, this,
          [this](const std::filesystem::path& file, SceneSaver::As as) {
            constexpr int readable = 4000;  // milliseconds
            if (const auto error = std::exchange(m_notSaved, std::nullopt))
              m_message.hideError(*error);
            m_window.statusBar()->showMessage(tr("Saved %1").arg(textOf(file.filename())),
                                              readable);
            if (as == SceneSaver::As::document)
              m_recent.add(textOf(file));
          });
  connect(&m_saver, &SceneSaver::ended, this, [this] {
    delete m_saving;
    // The user is asked again about edits that were made while it was written.
    if (const auto then = std::exchange(m_afterSaving, nullptr))
      whenSafe(then);
  });
}

void FileActions::dropped(const QStringList& paths) {
  const bool sceneAlone = paths.size() == 1 && model::isSceneFile(pathOf(paths.front()));
  if (m_dropHandler && !sceneAlone)
    m_dropHandler(paths);
  else
    open(paths);
}

void FileActions::open(const QStringList& paths) {
  if (paths.isEmpty())
    return;
  m_settings.setValue(QLatin1String(lastFolderKey), QFileInfo(paths.front()).absolutePath());
  whenSafe([this, paths] {
    std::vector<std::filesystem::path> files;
    for (const QString& path : paths)
      files.push_back(pathOf(path));
    m_session.openPaths(std::move(files));
  });
}

void FileActions::openRecent(const QString& path) {
  if (QFileInfo::exists(path))
    return open({path});
  m_recent.remove(path);
  m_message.showError({.file = path.toStdString(),
                       .reason = tr("it is no longer there").toStdString(),
                       .remedy = tr("Open it from where it is now").toStdString()});
}

void FileActions::openDemo(const DemoScene& demo) {
  whenSafe([this, demo] { m_session.openMade(demo.title, demo.make); });
}

void FileActions::recover(const model::Recoverable& found) {
  whenSafe([this, found] {
    m_session.openRecovered(found);
    std::erase_if(m_recoverable, [&](const auto& each) { return each.journal == found.journal; });
    m_actions[QStringLiteral("recover")].setEnabled(!m_recoverable.empty());
    emit recoverableChanged();
  });
}

void FileActions::forget(const model::Recoverable& found) {
  m_seeker.add([found](const std::stop_token&) {
    model::forget(found);
    return BackgroundQueue::Sequel();
  });
  std::erase_if(m_recoverable, [&](const auto& each) { return each.journal == found.journal; });
  m_actions[QStringLiteral("recover")].setEnabled(!m_recoverable.empty());
  emit recoverableChanged();
}

void FileActions::offerRecovery() {
  auto* dialog = new RecoveryDialog(&m_window);
  dialog->setFound(m_recoverable);
  connect(dialog, &RecoveryDialog::recoverWanted, this, &FileActions::recover);
  connect(dialog, &RecoveryDialog::forgetWanted, this, &FileActions::forget);
  connect(this, &FileActions::recoverableChanged, dialog,
          [this, dialog] { dialog->setFound(m_recoverable); });
  dialog->open();
}

void FileActions::whenSafe(const std::function<void()>& then) {
  if (m_saver.busy()) {
    m_afterSaving = then;
    return;
  }
  if (!m_session.modified())
    return then();
  askAboutUnsaved(m_window, {.title = m_session.title(),
                             .save =
                                 [this, then] {
                                   m_afterSaving = then;
                                   save();
                                 },
                             .discard =
                                 [this, then] {
                                   m_journaler.discard();
                                   then();
                                 }});
}

void FileActions::save() {
  const DocumentFile& file = m_session.file();
  if (file.path.empty() || file.writable != Writable::yes)
    saveAs(SceneSaver::As::document);
  else
    saveTo(textOf(file.path), SceneSaver::As::document);
}

void FileActions::saveAs(SceneSaver::As as) {
  chooseSceneFile(m_window,
                  {.title = as == SceneSaver::As::copy ? tr("Save a Copy") : tr("Save As"),
                   .suggestion = suggestedPath(),
                   .chosen = [this, as](const QString& path) { saveTo(path, as); },
                   .cancelled = [this] { m_afterSaving = nullptr; }});
}

void FileActions::saveTo(const QString& path, SceneSaver::As as) {
  m_settings.setValue(QLatin1String(lastFolderKey), QFileInfo(path).absolutePath());
  m_saver.save(pathOf(path), as,
               {.picture = m_viewport.isBlank() ? QImage() : m_viewport.picture(),
                .member = memberFor(m_viewport.camera())});
}

void FileActions::fileChange() {
  const DocumentFile& file = m_session.file();
  const bool any = m_session.document().opening != 0;
  const bool readOnly = file.writable != Writable::yes;
  QString name = m_session.title();
  // In a window's title "[*]" is the place for the mark of changes.
  name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
  if (readOnly)
    name = tr("%1 (read-only)").arg(name);
  m_window.setWindowTitle(any ? tr("%1[*] – Sline").arg(name) : tr("Sline"));
  m_window.setWindowModified(any && m_session.modified());
  m_window.setWindowFilePath(textOf(file.path));
  for (const char* id : {"saveAs", "saveCopy", "close"})
    m_actions[QLatin1String(id)].setEnabled(any);
  m_actions[QStringLiteral("save")].setEnabled(any && (m_session.modified() || file.path.empty()));
  m_actions[QStringLiteral("revert")].setEnabled(
      !file.path.empty() && (m_session.modified() || file.writable == Writable::changedOnDisk));
  if (!readOnly)
    return m_message.hideNotice();
  m_message.showNotice(tr("%1 is open read-only").arg(m_session.title()), file.reason,
                       m_actions[QStringLiteral("saveAs")]);
}

void FileActions::fillRecent(QMenu& menu) {
  menu.clear();
  const QStringList paths = m_recent.paths();
  for (qsizetype i = 0; i < paths.size(); ++i) {
    const QFileInfo file(paths[i]);
    QString name =
        file.fileName() + QStringLiteral("  –  ") + QDir::toNativeSeparators(file.path());
    QAction* action = menu.addAction(name.replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                                     [this, path = paths[i]] { openRecent(path); });
    action->setObjectName(QStringLiteral("recent-%1").arg(i));
  }
  menu.addSeparator();
  menu.addAction(tr("&Clear List"), this, [this] { m_recent.clear(); })
      ->setObjectName(QStringLiteral("clearRecent"));
}

QString FileActions::lastFolder() const {
  return m_settings.value(QLatin1String(lastFolderKey)).toString();
}

QString FileActions::suggestedPath() const {
  if (!m_session.file().path.empty())
    return textOf(m_session.file().path);
  QString name = m_session.publicTitle();
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  const QString folder = lastFolder().isEmpty() ? QDir::homePath() : lastFolder();
  return folder + QLatin1Char('/') + name + QStringLiteral(".sline");
}

bool FileActions::mayClose() {
  if (m_closing || (!m_session.modified() && !m_saver.busy()))
    return true;
  whenSafe([this] {
    m_closing = true;
    m_window.close();
    m_closing = false;
  });
  return false;
}

void FileActions::letGo() {
  m_journaler.discard();
}

}  // namespace sline::widgets

#include "moc_file_actions.cpp"
