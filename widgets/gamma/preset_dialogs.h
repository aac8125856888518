// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "widgets/gamma/preset_store.h"
#include "widgets/gamma/style_rows.h"

class QCheckBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace sline::widgets {

/// Asks for a name, and for the parts of a look that are to be kept.
class SavePresetDialog : public QDialog {
  Q_OBJECT
 public:
  SavePresetDialog(PresetStore& store, const model::Style& look, QWidget* parent);

 private:
  void update();
  void save();

  PresetStore& m_store;
  model::Style m_look;
  QLineEdit* m_name;
  QPushButton* m_save;
  struct Choice {
    model::Style which;
    QCheckBox* box;
  };
  std::vector<Choice> m_choices;
};

/// Renames and deletes presets.
class ManagePresetsDialog : public QDialog {
  Q_OBJECT
 public:
  ManagePresetsDialog(PresetStore& store, QWidget* parent);

 private:
  void fill();
  void renamed();

  PresetStore& m_store;
  QListWidget* m_list;
  QPushButton* m_rename;
  QPushButton* m_delete;
};

}  // namespace sline::widgets
