// SPDX-License-Identifier: Apache-2.0
#include "widgets/shell/message_bar.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>

#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

QString sentence(const QString& text) {
  QString s = text.trimmed();
  if (s.isEmpty())
    return s;
  s[0] = s[0].toUpper();
  return s.endsWith(QLatin1Char('.')) ? s : s + QLatin1Char('.');
}

QString headed(const QString& heading, const QString& body) {
  const QString title = heading.isEmpty()
                            ? QString()
                            : QStringLiteral("<b>%1</b>&ensp;").arg(heading.toHtmlEscaped());
  return title + body.trimmed().toHtmlEscaped();
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      m_text(new QLabel),
      m_details(new QPushButton),
      m_close(new QToolButton),
      m_remedy(new QPushButton),
      m_other(new QPushButton) {
  m_other->setObjectName(QStringLiteral("messageOther"));
  m_remedy->setObjectName(QStringLiteral("messageRemedy"));
  setObjectName(QStringLiteral("messageBar"));
  m_text->setObjectName(QStringLiteral("messageText"));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_details->setObjectName(QStringLiteral("messageDetails"));
  m_close->setObjectName(QStringLiteral("messageClose"));
  m_close->setText(QStringLiteral("✕"));
  m_close->setAutoRaise(true);
  nameControls();
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 8, 8, 8);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_details, 0, Qt::AlignTop);
  layout->addWidget(m_remedy, 0, Qt::AlignTop);
  layout->addWidget(m_other, 0, Qt::AlignTop);
  layout->addWidget(m_close, 0, Qt::AlignTop);
  connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
  connect(m_details, &QPushButton::clicked, this, &MessageBar::showDetails);
  hide();
}

void MessageBar::nameControls() {
  setAccessibleName(tr("Message"));
  m_close->setAccessibleName(tr("Close the message"));
  m_details->setText(tr("Show all %n", nullptr, int(m_remarks.size())));
}

QString MessageBar::text() const {
  return m_text->text();
}

void MessageBar::showError(const Error& error) {
  m_remarks.clear();
  m_error = error;
  display(Kind::error, {}, {});
  displayError();
}

void MessageBar::displayError() {
  const Error& error = m_error;
  QString heading = QString::fromStdString(error.file);
  if (!error.where.empty())
    heading += (heading.isEmpty() ? QString() : QStringLiteral(", ")) + told(error.where);
  m_text->setText(headed(
      heading, sentence(told(error.reason)) + QLatin1Char(' ') + sentence(told(error.remedy))));
}

void MessageBar::showRemarks(const QStringList& remarks) {
  m_remarks = remarks;
  display(Kind::remark, tr("Opened, with remarks"), told(remarks.value(0)));
}

void MessageBar::showNotice(const QString& heading, const QString& body, QAction& action) {
  m_remarks.clear();
  display(Kind::notice, heading, sentence(told(body)));
  offer(action);
}

void MessageBar::showDone(const QString& heading, const QString& body,
                          const QList<QAction*>& actions, const QStringList& remarks) {
  m_remarks = remarks;
  display(remarks.isEmpty() ? Kind::done : Kind::doneInPart, heading, remarks.value(0, body));
  if (!actions.isEmpty())
    offerOn(*m_remedy, *actions.front());
  if (actions.size() > 1)
    offerOn(*m_other, *actions.back());
}

void MessageBar::offer(QAction& action) {
  offerOn(*m_remedy, action);
}

void MessageBar::offerOther(QAction& action) {
  offerOn(*m_other, action);
}

void MessageBar::offerOn(QPushButton& button, QAction& action) {
  button.setText(QString(action.text()).remove(QLatin1Char('&')));
  button.setToolTip(action.toolTip());
  disconnect(&button, &QPushButton::clicked, nullptr, nullptr);
  connect(&button, &QPushButton::clicked, &action, &QAction::trigger);
  button.show();
}

void MessageBar::hideNotice() {
  if (m_kind == Kind::notice)
    hide();
}

void MessageBar::hideError(const Error& error) {
  if (m_kind == Kind::error && m_error == error)
    hide();
}

void MessageBar::hideDone() {
  if (m_kind == Kind::done || m_kind == Kind::doneInPart)
    hide();
}

void MessageBar::hideRemarks() {
  if (m_kind == Kind::remark)
    hide();
}

void MessageBar::display(Kind kind, const QString& heading, const QString& body) {
  m_text->setText(headed(heading, body));
  m_kind = kind;
  m_remedy->hide();
  m_other->hide();
  m_details->setVisible(m_remarks.size() > 1);
  nameControls();
  dress();
  show();
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    dress();
  // The bar outlives the other controls when the language changes, so that its message is not lost.
  if (event->type() == QEvent::LanguageChange) {
    nameControls();
    if (m_kind == Kind::error)
      displayError();
  }
}

void MessageBar::dress() {
  // Red stands for failures, amber for what the user should know, green for what is done.
  struct Colours {
    const char* light;
    const char* lightText;
    const char* dark;
    const char* darkText;
  };
  static constexpr std::array<Colours, 3> colours{{{"#f6d9d5", "#5a1410", "#54241f", "#f6d9d5"},
                                                   {"#f7ecc9", "#4d3b05", "#4a3d12", "#f7ecc9"},
                                                   {"#d9ecd6", "#173f14", "#23401f", "#d9ecd6"}}};
  const Colours& own = colours[m_kind == Kind::error ? 0 : m_kind == Kind::done ? 2 : 1];
  const QPalette& dressed = QApplication::palette();
  const bool dark =
      dressed.color(QPalette::Window).lightness() < dressed.color(QPalette::WindowText).lightness();
  const QString sheet = QStringLiteral(
                            "#messageBar { background: %1; } #messageBar QLabel, "
                            "#messageBar QToolButton { color: %2; }")
                            .arg(QLatin1String(dark ? own.dark : own.light),
                                 QLatin1String(dark ? own.darkText : own.lightText));
  if (sheet != styleSheet())
    setStyleSheet(sheet);
}

void MessageBar::showDetails() {
  auto* dialog = new QDialog(this);
  dialog->setObjectName(QStringLiteral("messageDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("What was left out or mended"));
  QStringList lines;
  for (const QString& remark : m_remarks)
    lines << told(remark);
  auto* list = new QPlainTextEdit(lines.join(QLatin1Char('\n')));
  list->setReadOnly(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(list);
  layout->addWidget(buttons);
  dialog->resize(720, 360);
  dialog->open();
}

}  // namespace sline::widgets

#include "moc_message_bar.cpp"
