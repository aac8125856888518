// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/text_fit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QStyle>
#include <QTabBar>
#include <QTextDocument>
#include <QToolBar>
#include <QToolButton>

namespace sline::test {

namespace {

int textWidth(const QWidget& widget, const QString& text) {
  int width = 0;
  for (const QString& line : text.split(QLatin1Char('\n')))
    width = std::max(width, widget.fontMetrics().size(Qt::TextShowMnemonic, line).width());
  return width;
}

QString report(const QWidget& widget, const QString& text, int there, int needed) {
  return QStringLiteral("%1 %2 “%3”: %4 of %5 pixels")
      .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text)
      .arg(there)
      .arg(needed);
}

/// Holds the text and the room that it needs and has; empty for a widget that shows no text.
struct Fit {
  QString text;
  int there = 0;
  int needed = 0;
};

Fit labelFit(const QLabel& label) {
  if (label.text().isEmpty())
    return {};
  const int there = label.contentsRect().width();
  if (label.wordWrap()) {
    const int needed = label.heightForWidth(label.width());
    // Each word must fit its line, and all lines together the height.
    return {label.text(), label.height(), needed};
  }
  return {label.text(), there, label.minimumSizeHint().width() - 2 * label.margin()};
}

Fit buttonFit(const QAbstractButton& button) {
  const QStyle& style = *button.style();
  int extra = 6;
  if (qobject_cast<const QCheckBox*>(&button))
    extra = style.pixelMetric(QStyle::PM_IndicatorWidth) +
            style.pixelMetric(QStyle::PM_CheckBoxLabelSpacing);
  else if (qobject_cast<const QRadioButton*>(&button))
    extra = style.pixelMetric(QStyle::PM_ExclusiveIndicatorWidth) +
            style.pixelMetric(QStyle::PM_RadioButtonLabelSpacing);
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  const bool iconOnly = tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly &&
                        (!tool->icon().isNull() || tool->arrowType() != Qt::NoArrow);
  if (iconOnly || button.text().isEmpty())
    return {};
  const bool beside = !tool || tool->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
  if (!button.icon().isNull() && beside)
    extra += button.iconSize().width() + 4;
  if (tool && tool->menu())
    extra += style.pixelMetric(QStyle::PM_MenuButtonIndicator);
  const int needed = textWidth(button, button.text()) + extra;
  return {button.text(), button.width(), std::min(needed, button.sizeHint().width())};
}

Fit fitOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget))
    return labelFit(*label);
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    return buttonFit(*button);
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    constexpr int arrow = 24;
    QString longest;
    for (int i = 0; i < box->count(); ++i)
      if (textWidth(*box, box->itemText(i)) > textWidth(*box, longest))
        longest = box->itemText(i);
    return {longest, box->width(), textWidth(*box, longest) + arrow};
  }
  if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget))
    return {box->text(), box->width(), box->minimumSizeHint().width()};
  if (const auto* edit = qobject_cast<const QLineEdit*>(&widget))
    return {edit->placeholderText(), edit->contentsRect().width(),
            textWidth(*edit, edit->placeholderText()) + 8};
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
    return {group->title(), group->width(), textWidth(*group, group->title()) + 8};
  if (const auto* bar = qobject_cast<const QMenuBar*>(&widget))
    return {QStringLiteral("menus"), bar->width(), bar->sizeHint().width()};
  if (const auto* dock = qobject_cast<const QDockWidget*>(&widget)) {
    constexpr int closeButton = 24;
    return {dock->windowTitle(), dock->width(),
            textWidth(*dock, dock->windowTitle()) + closeButton};
  }
  return {};
}

void addTabs(const QTabBar& bar, QStringList& out) {
  QStringList texts;
  for (int i = 0; i < bar.count(); ++i)
    texts << bar.tabText(i);
  // In less room, tabs are cut short or hidden behind arrows.
  if (bar.width() < bar.sizeHint().width())
    out << report(bar, texts.join(QStringLiteral(", ")), bar.width(), bar.sizeHint().width());
}

void addColumns(const QHeaderView& header, QStringList& out) {
  if (header.orientation() == Qt::Vertical || !header.model())
    return;
  for (int i = 0; i < header.count(); ++i) {
    const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
    const int needed = textWidth(header, text) + 6;
    if (!text.isEmpty() && !header.isSectionHidden(i) && header.sectionSize(i) < needed)
      out << report(header, text, header.sectionSize(i), needed);
  }
}

}  // namespace

QStringList clippedTexts(const QWidget& root) {
  QStringList out;
  QList<const QWidget*> all{&root};
  for (const QWidget* widget : root.findChildren<const QWidget*>())
    all << widget;
  for (const QWidget* widget : all) {
    if (!widget->isVisible())
      continue;
    // This button is Qt's own: if it moves a toolbar's buttons out of sight, the fault is ours.
    if (widget->objectName() == QLatin1String("qt_toolbar_ext_button"))
      out << QStringLiteral("%1: not all buttons have room").arg(widget->parent()->objectName());
    if (widget->objectName().startsWith(QLatin1String("qt_")))
      continue;
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
      addTabs(*tabs, out);
    if (const auto* header = qobject_cast<const QHeaderView*>(widget))
      addColumns(*header, out);
    const Fit fit = fitOf(*widget);
    if (!fit.text.isEmpty() && fit.there < fit.needed)
      out << report(*widget, fit.text, fit.there, fit.needed);
  }
  return out;
}

}  // namespace sline::test
