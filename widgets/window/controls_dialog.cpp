// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/controls_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/shell/menu_table.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

namespace {

QTreeWidgetItem* heading(QTreeWidget& rows, const QString& text) {
  auto* item = new QTreeWidgetItem(&rows, {text});
  item->setFirstColumnSpanned(true);
  item->setFlags(Qt::ItemIsEnabled);
  QFont font = rows.font();
  font.setBold(true);
  item->setFont(0, font);
  item->setExpanded(true);
  return item;
}

}  // namespace

ControlsDialog::ControlsDialog(const std::vector<ControlRow>& mouse, QWidget* parent)
    : QDialog(parent), m_rows(new QTreeWidget) {
  setObjectName(QStringLiteral("controlsDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Mouse and Keys"));
  auto* layout = new QVBoxLayout(this);
  auto* text = new QLineEdit;
  text->setObjectName(QStringLiteral("controlsFilter"));
  text->setPlaceholderText(tr("Filter"));
  text->setAccessibleName(tr("Filter"));
  text->setClearButtonEnabled(true);
  layout->addWidget(text);
  m_rows->setObjectName(QStringLiteral("controlsRows"));
  m_rows->setAccessibleName(windowTitle());
  m_rows->setColumnCount(2);
  m_rows->setHeaderHidden(true);
  m_rows->setRootIsDecorated(false);
  m_rows->setSelectionMode(QAbstractItemView::NoSelection);
  m_rows->setUniformRowHeights(true);
  fill(mouse);
  m_rows->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  layout->addWidget(m_rows);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  layout->addWidget(buttons);
  connect(text, &QLineEdit::textChanged, this, &ControlsDialog::filter);
  resize(900, 660);
}

void ControlsDialog::fill(const std::vector<ControlRow>& mouse) {
  const auto add = [this](const QString& title, const std::vector<ControlRow>& rows) {
    QTreeWidgetItem* group = heading(*m_rows, title);
    for (const ControlRow& row : rows)
      new QTreeWidgetItem(group, {row.control, row.meaning});
  };
  add(tr("Mouse"), mouse);
  add(tr("List of structures"), listRows());
  const std::vector<ActionRow> actions = actionRows();
  for (const MenuRow& menu : menuRows()) {
    QTreeWidgetItem* group = nullptr;
    for (const QString& entry : menu.entries) {
      const auto action = std::find_if(actions.begin(), actions.end(),
                                       [&](const ActionRow& row) { return row.id == entry; });
      if (action == actions.end() || action->keys.isEmpty())
        continue;
      if (!group)
        group = heading(*m_rows, QString(menu.text).remove(QLatin1Char('&')));
      new QTreeWidgetItem(
          group, {QKeySequence::listToString(action->keys, QKeySequence::NativeText), action->tip});
    }
  }
}

void ControlsDialog::filter(const QString& text) {
  for (int i = 0; i < m_rows->topLevelItemCount(); ++i) {
    QTreeWidgetItem& group = *m_rows->topLevelItem(i);
    bool any = false;
    for (int j = 0; j < group.childCount(); ++j) {
      QTreeWidgetItem& row = *group.child(j);
      const bool shown = row.text(0).contains(text, Qt::CaseInsensitive) ||
                         row.text(1).contains(text, Qt::CaseInsensitive);
      row.setHidden(!shown);
      any = any || shown;
    }
    group.setHidden(!any);
  }
}

}  // namespace sline::widgets

#include "moc_controls_dialog.cpp"
