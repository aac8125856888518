// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_card.h"

#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>

#include "widgets/theme/icons.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

namespace {

constexpr int gap = 3;  // between cards, on either side
constexpr double corner = 4.0;
constexpr int longestTyped = 200;

QRect pictureArea(const QRect& card) {
  return {card.topLeft() + QPoint(gap, gap), ViewCard::pictureSize()};
}

QRect nameArea(const QRect& card) {
  const QRect picture = pictureArea(card);
  return {picture.left(), picture.bottom() + 2, picture.width(),
          card.bottom() - gap - picture.bottom() - 1};
}

void paintPicture(QPainter& painter, const QRect& area, const QImage& picture,
                  const QPalette& palette) {
  if (!picture.isNull()) {
    painter.drawImage(area, picture);
    return;
  }
  painter.fillRect(area, palette.color(QPalette::AlternateBase));
  const int side = area.height() / 3;
  QRect middle(0, 0, side, side);
  middle.moveCenter(area.center());
  painter.setOpacity(0.35);
  lineIcon(QStringLiteral("view")).paint(&painter, middle);
  painter.setOpacity(1.0);
}

/// Paints the mark in amber, in light and dark, as warnings are everywhere.
void paintAbsent(QPainter& painter, const QRect& area) {
  constexpr double side = 15.0;
  const QRectF mark(area.right() - side - 3.0, area.top() + 4.0, side, side);
  painter.setPen(QPen(Qt::white, 1.0));
  painter.setBrush(QColor(0xffc47a00));
  painter.drawEllipse(mark);
  painter.setBrush(Qt::NoBrush);
  QFont bold = painter.font();
  bold.setBold(true);
  bold.setPixelSize(11);
  painter.save();
  painter.setFont(bold);
  painter.drawText(mark, Qt::AlignCenter, QStringLiteral("!"));
  painter.restore();
}

}  // namespace

QSize ViewCard::cardSize(const QFontMetrics& metrics) {
  return {pictureSize().width() + 2 * gap,
          pictureSize().height() + 2 * gap + 4 + metrics.lineSpacing()};
}

QSize ViewCard::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return cardSize(option.fontMetrics);
}

void ViewCard::paint(QPainter* painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const {
  const bool chosen = option.state.testFlag(QStyle::State_Selected);
  const bool under = option.state.testFlag(QStyle::State_MouseOver);
  const QPalette& palette = option.palette;
  const QRect area = pictureArea(option.rect);
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  QPainterPath shape;
  shape.addRoundedRect(QRectF(area), corner, corner);
  painter->save();
  painter->setClipPath(shape);
  paintPicture(*painter, area, index.data(Qt::DecorationRole).value<QImage>(), palette);
  painter->restore();
  QColor edge = palette.color(chosen || under ? QPalette::Highlight : QPalette::WindowText);
  if (!chosen)
    edge.setAlphaF(under ? 0.7F : 0.22F);
  painter->setPen(QPen(edge, chosen ? 2.0 : 1.0));
  painter->drawPath(shape);
  if (index.data(ViewList::absentRole).toULongLong() > 0)
    paintAbsent(*painter, area);
  painter->setPen(palette.color(QPalette::Text));
  const QRect line = nameArea(option.rect).adjusted(2, 0, -2, 0);
  painter->drawText(
      line, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextSingleLine,
      option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, line.width()));
  painter->restore();
}

QWidget* ViewCard::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                const QModelIndex&) const {
  auto* editor = new QLineEdit(parent);
  editor->setObjectName(QStringLiteral("viewName"));
  editor->setAccessibleName(tr("Name of the view"));
  editor->setMaxLength(longestTyped);
  editor->setFrame(false);
  editor->setAlignment(Qt::AlignHCenter);
  editor->setAutoFillBackground(true);
  return editor;
}

void ViewCard::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                    const QModelIndex&) const {
  editor->setGeometry(nameArea(option.rect));
}

}  // namespace sline::widgets

#include "moc_view_card.cpp"
