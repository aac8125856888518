// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/thumbnail_card.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <array>

#include "widgets/theme/icons.h"

namespace sline::widgets {

namespace {
constexpr int padding = 8;
constexpr double corner = 6.0;
constexpr int usualWidth = 176;

int pictureHeight(int width) {
  return width * 3 / 4;
}
}  // namespace

ThumbnailCard::ThumbnailCard(const QString& title, QWidget* parent) : QAbstractButton(parent) {
  setText(title);
  setAccessibleName(title);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
}

void ThumbnailCard::setLine(const QString& line) {
  m_line = line;
  setAccessibleDescription(line);
  update();
}

void ThumbnailCard::setPicture(const QImage& picture) {
  m_picture = picture;
  update();
}

void ThumbnailCard::setStandIn(const QString& icon) {
  m_standIn = icon;
  update();
}

void ThumbnailCard::setFaded(bool faded) {
  m_faded = faded;
  update();
}

QSize ThumbnailCard::sizeHint() const {
  return {usualWidth, heightForWidth(usualWidth)};
}

int ThumbnailCard::heightForWidth(int width) const {
  const int lines = m_line.isEmpty() ? 1 : 2;
  return pictureHeight(width) + 2 * padding + lines * fontMetrics().lineSpacing();
}

void ThumbnailCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const bool marked = hasFocus() || underMouse() || isDown() || isChecked();
  const double pen = hasFocus() || isChecked() ? 2.0 : 1.0;
  const QRectF frame = QRectF(rect()).adjusted(pen / 2, pen / 2, -pen / 2, -pen / 2);
  QPainterPath shape;
  shape.addRoundedRect(frame, corner, corner);
  painter.fillPath(shape, palette().color(isDown() ? QPalette::Midlight : QPalette::Base));
  painter.save();
  painter.setClipPath(shape);
  paintPicture(painter, QRectF(0, 0, width(), pictureHeight(width())));
  painter.restore();
  paintTexts(painter, rect().adjusted(padding + 2, pictureHeight(width()) + padding, -padding - 2,
                                      -padding));
  QColor edge = palette().color(marked ? QPalette::Highlight : QPalette::WindowText);
  if (!marked)
    edge.setAlphaF(0.22F);
  painter.setPen(QPen(edge, pen));
  painter.drawPath(shape);
  if (isChecked())
    paintCheckMark(painter);
}

/// Paints a tick in a disc, as colour alone would not tell everybody.
void ThumbnailCard::paintCheckMark(QPainter& painter) const {
  constexpr double radius = 9.0;
  const QPointF middle(width() - padding - radius, padding + radius);
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(middle, radius, radius);
  painter.setPen(QPen(palette().color(QPalette::HighlightedText), 2.0, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  const std::array tick{middle + QPointF(-4.0, 0.2), middle + QPointF(-1.2, 3.2),
                        middle + QPointF(4.2, -3.0)};
  painter.drawPolyline(tick.data(), int(tick.size()));
}

void ThumbnailCard::paintPicture(QPainter& painter, const QRectF& area) {
  if (m_faded)
    painter.setOpacity(0.4);
  if (m_picture.isNull()) {
    painter.fillRect(area, palette().color(QPalette::AlternateBase));
    const int side = int(area.height() / 3);
    QRect middle(0, 0, side, side);
    middle.moveCenter(area.center().toPoint());
    painter.setOpacity(m_faded ? 0.2 : 0.35);
    painter.drawPixmap(middle, lineIcon(m_standIn).pixmap(middle.size(), devicePixelRatioF()));
    painter.setOpacity(1.0);
    return;
  }
  // The whole picture is shown, and its background continues beside it.
  painter.fillRect(area, m_picture.pixelColor(0, 0));
  const QSizeF size = QSizeF(m_picture.size()).scaled(area.size(), Qt::KeepAspectRatio);
  QRectF place(QPointF(), size);
  place.moveCenter(area.center());
  painter.drawImage(place, m_picture);
  painter.setOpacity(1.0);
}

void ThumbnailCard::paintTexts(QPainter& painter, const QRect& area) {
  painter.setOpacity(m_faded ? 0.55 : 1.0);
  const QFontMetrics metrics = fontMetrics();
  QRect line(area.left(), area.top(), area.width(), metrics.lineSpacing());
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(text(), Qt::ElideRight, line.width()));
  line.translate(0, metrics.lineSpacing());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(m_line, Qt::ElideMiddle, line.width()));
  painter.setOpacity(1.0);
}

void ThumbnailCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    click();
  else
    QAbstractButton::keyPressEvent(event);
}

void ThumbnailCard::enterEvent(QEnterEvent* event) {
  QAbstractButton::enterEvent(event);
  update();
}

void ThumbnailCard::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  update();
}

}  // namespace sline::widgets

#include "moc_thumbnail_card.cpp"
