// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace sline::widgets {

RecoveryDialog::RecoveryDialog(QWidget* parent) : QDialog(parent), m_list(new RecoveryList) {
  setObjectName(QStringLiteral("recoveryDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Recover Unsaved Work"));
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(tr("Later"), QDialogButtonBox::RejectRole)
      ->setObjectName(QStringLiteral("recoverLater"));
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addWidget(new QLabel(tr("The program did not end as it should. It had kept:")));
  layout->addWidget(m_list);
  layout->addStretch(1);
  layout->addWidget(buttons);
  resize(680, 180);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &RecoveryList::forgetWanted, this, &RecoveryDialog::forgetWanted);
  connect(m_list, &RecoveryList::recoverWanted, this, [this](const model::Recoverable& found) {
    accept();
    emit recoverWanted(found);
  });
}

void RecoveryDialog::setFound(const std::vector<model::Recoverable>& found) {
  m_list->setFound(found);
  if (found.empty())
    close();
}

}  // namespace sline::widgets

#include "moc_recovery_dialog.cpp"
