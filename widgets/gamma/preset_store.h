// SPDX-License-Identifier: Apache-2.0
// Looks that a person has named, kept in the settings: they are for every scene.
#pragma once

#include <QObject>
#include <vector>

#include "model/edit/look.h"

class QSettings;

namespace sline::widgets {

class PresetStore : public QObject {
  Q_OBJECT
 public:
  /// The settings must outlive it.
  explicit PresetStore(QSettings& settings, QObject* parent = nullptr);

  /// By name. What the settings have of a preset that this program does not know is left out.
  std::vector<model::StylePreset> presets() const;
  bool has(const QString& name) const;
  /// Replaces one of that name. False where the name or the look says nothing.
  bool save(const QString& name, const model::Style& look);
  /// False where there is none of that name, or another has the new one.
  bool rename(const QString& from, const QString& to);
  bool remove(const QString& name);

 signals:
  void changed();

 private:
  void write(std::vector<model::StylePreset> presets);

  QSettings& m_settings;
};

}  // namespace sline::widgets
