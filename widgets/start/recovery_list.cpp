// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/recovery_list.h"

#include <QDateTime>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <chrono>

namespace sline::widgets {

namespace {

QString titleOf(const model::Recoverable& found) {
  return found.source.title.empty() ? RecoveryList::tr("A damaged copy")
                                    : QString::fromStdString(found.source.title);
}

QString whenOf(const model::Recoverable& found) {
  using namespace std::chrono;
  const auto when = file_clock::to_sys(found.when).time_since_epoch();
  return QLocale().toString(
      QDateTime::fromMSecsSinceEpoch(duration_cast<milliseconds>(when).count()),
      QLocale::ShortFormat);
}

QString fileOf(const model::Recoverable& found) {
  if (found.source.file.empty())
    return RecoveryList::tr("never saved");
  const QString file = QDir::toNativeSeparators(QString::fromStdString(found.source.file.string()));
  return found.source.file.is_absolute() ? file
                                         : RecoveryList::tr("%1, in an unknown folder").arg(file);
}

QPushButton* button(const QString& text, const QString& name, const QString& title) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  made->setAccessibleName(QStringLiteral("%1: %2").arg(text, title));
  return made;
}

}  // namespace

RecoveryList::RecoveryList(QWidget* parent) : QWidget(parent), m_rows(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("recoveryList"));
  m_rows->setContentsMargins(0, 0, 0, 0);
  m_rows->setSpacing(8);
}

void RecoveryList::setFound(const std::vector<model::Recoverable>& found) {
  while (QLayoutItem* item = m_rows->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    m_rows->addWidget(row(found[i], i));
  setFocusProxy(found.empty() ? nullptr
                              : m_rows->itemAt(0)->widget()->findChild<QPushButton*>(
                                    QStringLiteral("recover-0")));
}

QWidget* RecoveryList::row(const model::Recoverable& found, std::size_t number) {
  const QString title = titleOf(found);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* name = new QLabel(title);
  name->setTextFormat(Qt::PlainText);
  QFont bold = name->font();
  bold.setBold(true);
  name->setFont(bold);
  auto* rest = new QLabel(tr("%1, %2").arg(whenOf(found), fileOf(found)));
  rest->setTextFormat(Qt::PlainText);
  rest->setWordWrap(true);
  auto* recover = button(tr("Recover"), QStringLiteral("recover-%1").arg(number), title);
  auto* forget = button(tr("Delete"), QStringLiteral("forget-%1").arg(number), title);
  layout->addWidget(name);
  layout->addWidget(rest, 1);
  layout->addWidget(recover);
  layout->addWidget(forget);
  connect(recover, &QPushButton::clicked, this, [this, found] { emit recoverWanted(found); });
  connect(forget, &QPushButton::clicked, this, [this, found] { askToForget(found); });
  return row;
}

void RecoveryList::askToForget(const model::Recoverable& found) {
  auto* box = new QMessageBox(window());
  box->setObjectName(QStringLiteral("forgetDialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setIcon(QMessageBox::Warning);
  box->setTextFormat(Qt::PlainText);
  box->setText(tr("Delete the unsaved work on “%1”?").arg(titleOf(found)));
  box->setInformativeText(tr("It cannot be brought back."));
  QPushButton* go = box->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  go->setObjectName(QStringLiteral("forgetCopy"));
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  connect(box, &QDialog::finished, this, [this, box, go, found] {
    if (box->clickedButton() == go)
      emit forgetWanted(found);
  });
  box->open();
}

}  // namespace sline::widgets

#include "moc_recovery_list.cpp"
