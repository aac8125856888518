// SPDX-License-Identifier: Apache-2.0
// Keeps the looks that the user has named in the settings, because they apply to every scene.
#pragma once

#include <QObject>
#include <vector>

#include "model/edit/look.h"

class QSettings;

namespace sline::widgets {

class PresetStore : public QObject {
  Q_OBJECT
 public:
  /// Reads from the settings, which must outlive it.
  explicit PresetStore(QSettings& settings, QObject* parent = nullptr);

  /// Returns the presets by name, without those parts in the settings that this program does not
  /// know.
  std::vector<model::StylePreset> presets() const;
  bool has(const QString& name) const;
  /// Saves the preset, replacing one of that name. Returns false where the name or the look is
  /// empty.
  bool save(const QString& name, const model::Style& look);
  /// Renames a preset; returns false where `from` does not exist or another preset is called `to`.
  bool rename(const QString& from, const QString& to);
  bool remove(const QString& name);

 signals:
  void changed();

 private:
  void write(std::vector<model::StylePreset> presets);

  QSettings& m_settings;
};

}  // namespace sline::widgets
