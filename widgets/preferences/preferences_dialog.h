// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "widgets/preferences/preferences.h"

class QFormLayout;

namespace sline::widgets {

/// Shows a tab for each page of the table and a control for each row (its objectName is the row's
/// id). Each change applies at once; nothing waits for a button.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(Preferences& preferences, QWidget* parent = nullptr);

 private:
  void add(const Field& field, QFormLayout& form);

  Preferences& m_preferences;
};

}  // namespace sline::widgets
