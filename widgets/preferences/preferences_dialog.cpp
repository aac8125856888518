// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preferences_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/preferences/preference_control.h"

namespace sline::widgets {

PreferencesDialog::PreferencesDialog(Preferences& preferences, QWidget* parent)
    : QDialog(parent), m_preferences(preferences) {
  setObjectName(QStringLiteral("preferencesDialog"));
  setWindowTitle(tr("Preferences"));
  // A dialog that is closed but still exists would be taken for an open one when the language
  // changes.
  setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(this);
  auto* pages = new QTabWidget;
  pages->setObjectName(QStringLiteral("preferencePages"));
  layout->addWidget(pages);
  QFormLayout* form = nullptr;
  for (const PreferenceRow& row : preferenceRows()) {
    if (pages->count() == 0 || pages->tabText(pages->count() - 1) != row.page) {
      auto* page = new QWidget;
      form = new QFormLayout(page);
      form->setContentsMargins(16, 16, 16, 16);
      form->setHorizontalSpacing(16);
      form->setVerticalSpacing(10);
      pages->addTab(page, row.page);
    }
    add(row.field, *form);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults);
  QPushButton* restore = buttons->button(QDialogButtonBox::RestoreDefaults);
  restore->setObjectName(QStringLiteral("restoreStandards"));
  // Enter closes the dialog; it must not undo what was chosen.
  restore->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(restore, &QPushButton::clicked, this, [this] { m_preferences.restoreStandards(); });
  layout->addWidget(buttons);
  setMinimumWidth(440);
}

void PreferencesDialog::add(const Field& field, QFormLayout& form) {
  QWidget* control = makePreferenceControl(m_preferences, field.id);
  if (std::holds_alternative<SwitchField>(field.kind))
    form.addRow(QString(), control);
  else
    form.addRow(tr("%1:").arg(field.text), control);
}

}  // namespace sline::widgets

#include "moc_preferences_dialog.cpp"
