// SPDX-License-Identifier: Apache-2.0
#include "widgets/help/help_window.h"

#include <QAction>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/help/help_browser.h"
#include "widgets/help/help_pages.h"
#include "widgets/shell/filter_line.h"

namespace sline::widgets {

namespace {
constexpr int idRole = Qt::UserRole;
}

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_search(
          makeFilterLine(QStringLiteral("helpSearch"), tr("Search in help"), tr("Search in help"))),
      m_contents(new QListWidget),
      m_page(new HelpBrowser) {
  setObjectName(QStringLiteral("helpWindow"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Help"));
  m_page->setObjectName(QStringLiteral("helpPage"));
  m_page->setAccessibleName(tr("Page"));
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(m_page, 1);
  auto* parts = new QSplitter;
  parts->setChildrenCollapsible(false);
  parts->addWidget(makeContents());
  parts->addWidget(right);
  parts->setStretchFactor(1, 1);
  parts->setSizes({240, 700});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(parts);
  connect(m_page, &HelpBrowser::pageShown, this, &HelpWindow::mark);
  connect(m_page, &HelpBrowser::outsideWanted, this, &HelpWindow::askBeforeLeaving);
  auto* close = new QAction(this);
  close->setShortcut(Qt::Key_Escape);
  connect(close, &QAction::triggered, this, &QWidget::close);
  addAction(close);
  list();
  resize(960, 680);
}

QWidget* HelpWindow::makeContents() {
  m_contents->setObjectName(QStringLiteral("helpContents"));
  m_contents->setAccessibleName(tr("Contents"));
  m_contents->setFrameShape(QFrame::NoFrame);
  m_contents->setWordWrap(true);
  m_contents->setSpacing(2);
  connect(m_search, &QLineEdit::textChanged, this, &HelpWindow::list);
  connect(m_search, &QLineEdit::returnPressed, this, [this] {
    if (m_contents->count() > 0)
      m_page->showPage(m_contents->item(0)->data(idRole).toString());
    findWords();
  });
  connect(m_contents, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item && item->data(idRole).toString() != m_page->page()) {
      m_page->showPage(item->data(idRole).toString());
      findWords();
    }
  });
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(8, 8, 0, 0);
  column->addWidget(m_search);
  column->addWidget(m_contents, 1);
  return left;
}

QWidget* HelpWindow::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(8, 8, 8, 4);
  const auto button = [&](const char* id, const QString& text, Qt::ArrowType arrow) {
    auto* made = new QToolButton;
    made->setObjectName(QLatin1String(id));
    made->setText(text);
    made->setAccessibleName(text);
    made->setToolTip(text);
    made->setArrowType(arrow);
    made->setAutoRaise(true);
    made->setEnabled(false);
    made->setFocusPolicy(Qt::TabFocus);
    row->addWidget(made);
    return made;
  };
  QToolButton* back = button("helpBack", tr("Back"), Qt::LeftArrow);
  QToolButton* forward = button("helpForward", tr("Forward"), Qt::RightArrow);
  back->setShortcut(QKeySequence::Back);
  forward->setShortcut(QKeySequence::Forward);
  row->addStretch(1);
  connect(back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, m_page, &QTextBrowser::forward);
  connect(m_page, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(m_page, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  return bar;
}

void HelpWindow::showPage(const QString& id) {
  m_search->clear();
  m_page->showPage(id);
}

void HelpWindow::list() {
  const QSignalBlocker quiet(m_contents);
  m_contents->clear();
  for (const QString& id : helpPagesWith(m_search->text(), QLocale())) {
    auto* item = new QListWidgetItem(helpTitle(id, QLocale()), m_contents);
    item->setData(idRole, id);
  }
  mark(m_page->page());
}

void HelpWindow::mark(const QString& id) {
  const QSignalBlocker quiet(m_contents);
  for (int row = 0; row < m_contents->count(); ++row)
    if (m_contents->item(row)->data(idRole).toString() == id)
      m_contents->setCurrentRow(row);
}

void HelpWindow::findWords() {
  const QString first = m_search->text().section(QLatin1Char(' '), 0, 0, QString::SectionSkipEmpty);
  if (first.isEmpty())
    return;
  m_page->moveCursor(QTextCursor::Start);
  m_page->find(first);
}

void HelpWindow::askBeforeLeaving(const QUrl& address) {
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Open in the Browser?"),
      tr("This link leads out of the program, to\n%1").arg(address.toDisplayString()),
      QMessageBox::Open | QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("outsideDialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setDefaultButton(QMessageBox::Cancel);
  connect(box, &QMessageBox::accepted, this, [address] { QDesktopServices::openUrl(address); });
  box->open();
}

}  // namespace sline::widgets

#include "moc_help_window.cpp"
