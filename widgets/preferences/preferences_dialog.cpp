// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace sline::widgets {

PreferencesDialog::PreferencesDialog(Preferences& preferences, QWidget* parent)
    : QDialog(parent), m_preferences(preferences) {
  setObjectName(QStringLiteral("preferencesDialog"));
  setWindowTitle(tr("Preferences"));
  // One that is closed but there would be taken for the one that another language finds open.
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
    add(row, *form);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults);
  QPushButton* restore = buttons->button(QDialogButtonBox::RestoreDefaults);
  restore->setObjectName(QStringLiteral("restoreStandards"));
  // Enter closes; it must not undo what was chosen.
  restore->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(restore, &QPushButton::clicked, this, [this] { m_preferences.restoreStandards(); });
  layout->addWidget(buttons);
  setMinimumWidth(440);
}

void PreferencesDialog::add(const PreferenceRow& row, QFormLayout& form) {
  QWidget* made = std::visit([&](const auto& kind) { return control(row, kind); }, row.kind);
  made->setObjectName(row.id);
  made->setToolTip(row.tip);
  made->setAccessibleName(row.text);
  made->setAccessibleDescription(row.tip);
  if (std::holds_alternative<Switch>(row.kind))
    form.addRow(QString(), made);
  else
    form.addRow(tr("%1:").arg(row.text), made);
}

QWidget* PreferencesDialog::control(const PreferenceRow& row, const Switch&) {
  auto* box = new QCheckBox(row.text);
  const auto read = [this, box, id = row.id] { box->setChecked(m_preferences.isOn(id)); };
  read();
  connect(box, &QCheckBox::toggled, this,
          [this, id = row.id](bool on) { m_preferences.set(id, on); });
  connect(&m_preferences, &Preferences::changed, box, read);
  return box;
}

QWidget* PreferencesDialog::control(const PreferenceRow& row, const ChoiceOf& kind) {
  auto* box = new QComboBox;
  for (const ChoiceOf::Row& choice : kind.rows)
    box->addItem(choice.text, choice.id);
  const auto read = [this, box, id = row.id] {
    box->setCurrentIndex(box->findData(m_preferences.choice(id)));
  };
  read();
  connect(box, &QComboBox::currentIndexChanged, this,
          [this, box, id = row.id](int at) { m_preferences.set(id, box->itemData(at)); });
  connect(&m_preferences, &Preferences::changed, box, read);
  return box;
}

QWidget* PreferencesDialog::control(const PreferenceRow& row, const WholeNumber& kind) {
  auto* box = new QSpinBox;
  box->setRange(kind.low, kind.high);
  if (!kind.unit.isEmpty())
    box->setSuffix(QLatin1Char(' ') + kind.unit);
  box->setSpecialValueText(kind.lowestText);
  const auto read = [this, box, id = row.id] { box->setValue(m_preferences.number(id)); };
  read();
  connect(box, &QSpinBox::valueChanged, this,
          [this, id = row.id](int number) { m_preferences.set(id, number); });
  connect(&m_preferences, &Preferences::changed, box, read);
  return box;
}

}  // namespace sline::widgets

#include "moc_preferences_dialog.cpp"
