// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/preset_dialogs.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace sline::widgets {

namespace {
constexpr int nameRole = Qt::UserRole;
}  // namespace

SavePresetDialog::SavePresetDialog(PresetStore& store, const model::Style& look, QWidget* parent)
    : QDialog(parent), m_store(store), m_look(look), m_name(new QLineEdit) {
  setObjectName(QStringLiteral("savePresetDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Save Preset"));
  m_name->setObjectName(QStringLiteral("presetName"));
  m_name->setMaxLength(60);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), m_name);
  layout->addLayout(form);
  layout->addWidget(new QLabel(tr("What it keeps of the look:")));
  for (const StyleField& field : styleFields()) {
    if (model::picked(look, field.which) == model::Style())
      continue;  // ink without a colour of its own
    auto* box = new QCheckBox(field.text);
    box->setObjectName(QStringLiteral("keep-") + field.id);
    box->setChecked(field.usual);
    connect(box, &QCheckBox::toggled, this, &SavePresetDialog::update);
    m_choices.push_back({field.which, box});
    layout->addWidget(box);
  }
  layout->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  m_save = buttons->button(QDialogButtonBox::Save);
  m_save->setObjectName(QStringLiteral("savePresetButton"));
  layout->addWidget(buttons);
  connect(m_name, &QLineEdit::textChanged, this, &SavePresetDialog::update);
  connect(buttons, &QDialogButtonBox::accepted, this, &SavePresetDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  update();
}

void SavePresetDialog::update() {
  bool any = false;
  for (const Choice& choice : m_choices)
    any = any || choice.box->isChecked();
  m_save->setEnabled(any && !m_name->text().trimmed().isEmpty());
  m_save->setText(m_store.has(m_name->text()) ? tr("Replace") : tr("Save"));
}

void SavePresetDialog::save() {
  model::Style kept;
  for (const Choice& choice : m_choices)
    if (choice.box->isChecked())
      model::patch(kept, model::picked(m_look, choice.which));
  if (m_store.save(m_name->text(), kept))
    accept();
}

ManagePresetsDialog::ManagePresetsDialog(PresetStore& store, QWidget* parent)
    : QDialog(parent),
      m_store(store),
      m_list(new QListWidget),
      m_rename(new QPushButton(tr("&Rename"))),
      m_delete(new QPushButton(tr("&Delete"))) {
  setObjectName(QStringLiteral("managePresetsDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Presets"));
  m_list->setObjectName(QStringLiteral("presetList"));
  m_list->setAccessibleName(tr("Presets"));
  m_rename->setObjectName(QStringLiteral("renamePreset"));
  m_delete->setObjectName(QStringLiteral("deletePreset"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->addButton(m_rename, QDialogButtonBox::ActionRole);
  buttons->addButton(m_delete, QDialogButtonBox::ActionRole);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_list);
  layout->addWidget(buttons);
  resize(360, 300);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_rename, &QPushButton::clicked, this,
          [this] { m_list->editItem(m_list->currentItem()); });
  connect(m_delete, &QPushButton::clicked, this, [this] {
    m_store.remove(m_list->currentItem()->data(nameRole).toString());
    fill();
  });
  connect(m_list, &QListWidget::itemChanged, this, &ManagePresetsDialog::renamed,
          Qt::QueuedConnection);
  fill();
}

void ManagePresetsDialog::fill() {
  const QSignalBlocker quiet(m_list);
  const int row = m_list->currentRow();
  m_list->clear();
  for (const model::StylePreset& preset : m_store.presets()) {
    const QString name = QString::fromStdString(preset.name);
    auto* item = new QListWidgetItem(name, m_list);
    item->setData(nameRole, name);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  m_list->setCurrentRow(std::clamp(row, 0, std::max(0, m_list->count() - 1)));
  m_rename->setEnabled(m_list->count() > 0);
  m_delete->setEnabled(m_list->count() > 0);
}

void ManagePresetsDialog::renamed() {
  // An unacceptable name goes back to what it was.
  for (int i = 0; i < m_list->count(); ++i) {
    const QListWidgetItem& item = *m_list->item(i);
    const QString before = item.data(nameRole).toString();
    if (item.text() != before)
      m_store.rename(before, item.text());
  }
  fill();
}

}  // namespace sline::widgets

#include "moc_preset_dialogs.cpp"
