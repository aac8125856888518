// SPDX-License-Identifier: Apache-2.0
// Takes files that the window did not ask for: dropped on it, or handed over by another start of
// the program.
#include <QApplication>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>
#include <algorithm>

#include "widgets/import_dialog/import_actions.h"
#include "widgets/instance/hand_over.h"
#include "widgets/window/file_actions.h"
#include "widgets/window/main_window.h"

namespace sline::widgets {

namespace {
bool hasLocalFiles(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
}
}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (hasLocalFiles(*event->mimeData()))
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile())
      paths << url.toLocalFile();
  event->acceptProposedAction();
  openDropped(paths, event->modifiers());
}

void MainWindow::openDropped(const QStringList& paths, Qt::KeyboardModifiers keys) {
  if (!m_imports->asksFor(paths, keys))
    m_files->dropped(paths);
}

bool MainWindow::isFree() const {
  return !QApplication::activeModalWidget() && !QApplication::activePopupWidget();
}

void MainWindow::take(const HandedFiles& files) {
  // Qt passes the token on when a window is activated (Wayland).
  if (!files.activationToken.isEmpty())
    qputenv("XDG_ACTIVATION_TOKEN", files.activationToken.toUtf8());
  setWindowState(windowState() & ~Qt::WindowMinimized);
  show();
  raise();
  activateWindow();
  QApplication::alert(this);
  qunsetenv("XDG_ACTIVATION_TOKEN");
  openDropped(files.paths, {});
}

}  // namespace sline::widgets
