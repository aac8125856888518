// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>

class QSettings;

namespace sline::widgets {

/// Keeps the list of files that were opened and saved last in the settings.
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  static constexpr int most = 10;

  /// Uses the settings, which must outlive it.
  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);
  /// Returns absolute paths, the newest first.
  QStringList paths() const;
  /// Puts the path first.
  void add(const QString& path);
  void remove(const QString& path);
  void clear();

 signals:
  void changed();

 private:
  void set(const QStringList& paths);
  QSettings& m_settings;
};

}  // namespace sline::widgets
