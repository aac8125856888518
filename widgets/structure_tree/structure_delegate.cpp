// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_delegate.h"

#include <QApplication>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>

#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/elided_name.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

using Model = StructureTreeModel;

namespace {

std::vector<QColor> coloursOf(const QModelIndex& index) {
  std::vector<QColor> colours;
  for (const QVariant& colour : index.data(Model::coloursRole).toList())
    colours.push_back(colour.value<QColor>());
  return colours;
}

}  // namespace

void StructureDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyleOptionViewItem look = option;
  initStyleOption(&look, index);
  const auto shown = model::Visibility(index.data(Model::shownRole).toInt());
  if (index.column() == Model::name && shown == model::Visibility::none)
    look.palette.setColor(QPalette::Text, look.palette.color(QPalette::Disabled, QPalette::Text));
  if (index.column() == Model::name)
    look.text = nameIn(look, index);
  // The row has one highlight; a frame around a single cell has no meaning here.
  look.state &= ~QStyle::State_HasFocus;
  const QStyle* style = look.widget ? look.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &look, painter, look.widget);
  if (index.column() == Model::name)
    return;

  const bool selected = look.state & QStyle::State_Selected;
  QPalette palette = look.palette;
  if (selected)
    palette.setColor(QPalette::Text, palette.color(QPalette::HighlightedText));
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QRectF cell(look.rect);
  const auto lock = RowLock(index.data(Model::lockRole).toInt());
  if (index.column() == Model::eye)
    paintEye(*painter, cell, shown, palette);
  else if (index.column() == Model::swatch)
    paintSwatch(*painter, cell,
                {.colours = coloursOf(index),
                 .opacity = index.data(Model::opacityRole).toFloat(),
                 .own = index.data(Model::ownColourRole).toBool()},
                palette);
  else if (index.column() == Model::lock)
    paintLock(*painter, cell, lock, look.state.testFlag(QStyle::State_MouseOver), palette);
  else
    paintGamma(*painter, {cell},
               {.range = {Gamma::clamped(index.data(Model::lowGammaRole).toFloat()),
                          Gamma::clamped(index.data(Model::highGammaRole).toFloat())},
                .own = index.data(Model::ownGammaRole).toBool(),
                .selected = selected,
                .locked = lock != RowLock::open},
               palette);
  painter->restore();
}

QString StructureDelegate::nameIn(const QStyleOptionViewItem& look,
                                  const QModelIndex& index) const {
  const QStyle& style = look.widget ? *look.widget->style() : *QApplication::style();
  // As wide as QCommonStyle writes.
  const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &look, look.widget) + 1;
  const int width = style.subElementRect(QStyle::SE_ItemViewItemText, &look, look.widget).width() -
                    2 * margin - 1;
  if (look.fontMetrics.horizontalAdvance(look.text) <= width)
    return look.text;
  Shown& shown = m_shown[index.internalId()];
  if (shown.name == look.text && shown.width == width)
    return shown.text;
  QStringList& together = m_together[index.parent().internalId()];
  if (together.isEmpty())
    for (int row = 0; row < index.model()->rowCount(index.parent()); ++row)
      together << index.siblingAtRow(row).data().toString();
  shown = {look.text, width, elidedName(look.text, together, look.fontMetrics, width)};
  return shown.text;
}

void StructureDelegate::forgetNames() {
  m_together.clear();
  m_shown.clear();
}

QWidget* StructureDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                         const QModelIndex&) const {
  auto* editor = new QLineEdit(parent);
  editor->setObjectName(QStringLiteral("nameEditor"));
  editor->setAccessibleName(tr("Name"));
  editor->setFrame(false);
  editor->setAutoFillBackground(true);
  return editor;
}

QSize StructureDelegate::sizeHint(const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  size.setHeight(std::max(size.height(), 26));
  return size;
}

}  // namespace sline::widgets

#include "moc_structure_delegate.cpp"
