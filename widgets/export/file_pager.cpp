// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/file_pager.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace sline::widgets {

namespace {

QToolButton* arrowButton(Qt::ArrowType arrow, const char* name, const QString& text) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setArrowType(arrow);
  button->setAutoRaise(true);
  button->setAutoRepeat(true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setToolTip(text);
  button->setAccessibleName(text);
  return button;
}

}  // namespace

FilePager::FilePager(QWidget* parent)
    : QWidget(parent),
      m_back(arrowButton(Qt::LeftArrow, "exportPageBack", tr("Preview of what comes before"))),
      m_text(new QLabel),
      m_on(arrowButton(Qt::RightArrow, "exportPageOn", tr("Preview of what comes next"))) {
  m_text->setObjectName(QStringLiteral("exportPageName"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setAlignment(Qt::AlignCenter);
  // A long name must not widen the window.
  m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_back);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_on);
  connect(m_back, &QToolButton::clicked, this, [this] { turnTo(m_index - 1); });
  connect(m_on, &QToolButton::clicked, this, [this] { turnTo(m_index + 1); });
  hide();
}

void FilePager::setNames(const QStringList& names) {
  if (names.size() != m_names.size())
    m_index = 0;
  m_names = names;
  showIndex();
}

void FilePager::turnTo(std::size_t index) {
  m_index = index;
  showIndex();
  emit turned();
}

void FilePager::showIndex() {
  setVisible(m_names.size() > 1);
  if (m_names.size() < 2)
    return;
  const QString& name = m_names[qsizetype(m_index)];
  m_text->setText(
      tr("%1 (%2 of %3)").arg(name, QString::number(m_index + 1), QString::number(m_names.size())));
  m_text->setToolTip(name);
  m_back->setEnabled(m_index > 0);
  m_on->setEnabled(qsizetype(m_index) + 1 < m_names.size());
}

}  // namespace sline::widgets

#include "moc_file_pager.cpp"
