// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presentation_board.h"

#include <QMouseEvent>
#include <QPainter>
#include <QRadialGradient>
#include <algorithm>

namespace sline::widgets {

namespace {

constexpr QRgb penInk = 0xffd1202f;
// Shares of the picture's height.
constexpr double strokeWidth = 0.004;
constexpr double dotRadius = 0.011;

}  // namespace

PresentationBoard::PresentationBoard(QWidget& picture) : QWidget(&picture) {
  setObjectName(QStringLiteral("presentationBoard"));
  hide();
  showState();
}

void PresentationBoard::showState() {
  const bool drawing = m_pointing == Pointing::pen;
  setAttribute(Qt::WA_TransparentForMouseEvents, !drawing && m_blank == Blank::none);
  if (m_blank != Blank::none)
    setCursor(Qt::BlankCursor);
  else
    setCursor(drawing ? Qt::CrossCursor : Qt::ArrowCursor);
  raise();
  update();
}

void PresentationBoard::setBlank(Blank blank) {
  m_blank = blank;
  showState();
}

void PresentationBoard::setPointing(Pointing pointing) {
  m_pointing = pointing;
  m_drawing = false;
  showState();
}

void PresentationBoard::point(const std::optional<QPointF>& at) {
  m_mouse = at;
  if (m_pointing == Pointing::laser)
    update();
}

std::optional<QPointF> PresentationBoard::dot() const {
  return m_pointing == Pointing::laser && m_blank == Blank::none ? m_mouse : std::nullopt;
}

void PresentationBoard::wipe() {
  m_drawn.clear();
  m_drawing = false;
  update();
}

void PresentationBoard::clear() {
  wipe();
  setBlank(Blank::none);
  setPointing(Pointing::mouse);
}

void PresentationBoard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (m_blank != Blank::none) {
    painter.fillRect(rect(), m_blank == Blank::black ? Qt::black : Qt::white);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const double pen = std::max(2.0, strokeWidth * height());
  painter.setPen(QPen(QColor(penInk), pen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const QPolygonF& stroke : m_drawn)
    if (stroke.size() == 1)
      painter.drawPoint(stroke.front());
    else
      painter.drawPolyline(stroke);
  if (const std::optional<QPointF> at = dot()) {
    const double radius = std::max(6.0, dotRadius * height());
    QRadialGradient light(*at, radius);
    light.setColorAt(0.0, QColor(255, 96, 96));
    light.setColorAt(0.45, QColor(235, 0, 0, 235));
    light.setColorAt(1.0, QColor(235, 0, 0, 0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(light);
    painter.drawEllipse(*at, radius, radius);
  }
}

void PresentationBoard::mousePressEvent(QMouseEvent* event) {
  if (m_pointing != Pointing::pen || m_blank != Blank::none || event->button() != Qt::LeftButton)
    return;
  m_drawing = true;
  m_drawn.push_back({event->position()});
  update();
}

void PresentationBoard::mouseMoveEvent(QMouseEvent* event) {
  if (!m_drawing)
    return;
  m_drawn.back().push_back(event->position());
  update();
}

void PresentationBoard::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    m_drawing = false;
}

void PresentationBoard::wheelEvent(QWheelEvent* event) {
  event->accept();  // a picture that moved would slip from under what is drawn
}

}  // namespace sline::widgets

#include "moc_presentation_board.cpp"
