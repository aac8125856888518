// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/recent_files.h"

#include <QDir>
#include <QSettings>

namespace sline::widgets {

namespace {
constexpr const char* key = "files/recent";
}

RecentFiles::RecentFiles(QSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {}

QStringList RecentFiles::paths() const {
  return m_settings.value(QLatin1String(key)).toStringList().mid(0, most);
}

void RecentFiles::add(const QString& path) {
  // The path is resolved without asking the disk, which may be far away.
  const QString absolute = QDir::cleanPath(QDir().absoluteFilePath(path));
  QStringList paths = this->paths();
  paths.removeAll(absolute);
  paths.prepend(absolute);
  set(paths.mid(0, most));
}

void RecentFiles::remove(const QString& path) {
  QStringList paths = this->paths();
  paths.removeAll(path);
  set(paths);
}

void RecentFiles::clear() {
  set({});
}

void RecentFiles::set(const QStringList& paths) {
  if (paths == this->paths())
    return;
  m_settings.setValue(QLatin1String(key), paths);
  emit changed();
}

}  // namespace sline::widgets

#include "moc_recent_files.cpp"
