// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>

class QSettings;

namespace sline::widgets {

/// What was opened and saved last, in the settings.
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  static constexpr int most = 10;

  /// The settings must outlive it.
  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);
  /// Absolute, the newest first.
  QStringList paths() const;
  /// Puts it first.
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
