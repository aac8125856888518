// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/near_mark.h"

#include <QPainter>

namespace sline::widgets {

namespace {

constexpr double nearThin = 1.4;  ///< pixels
constexpr double nearHalo = 2.4;  ///< pixels around the line
constexpr double ringRadius = 7.0;

}  // namespace

NearMark::NearMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("nearMark"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void NearMark::show(const State& state) {
  if (state == m_state)
    return;
  m_state = state;
  setVisible(m_state.place.has_value());
  update();
}

void NearMark::setDark(bool dark) {
  m_dark = dark;
  update();
}

void NearMark::paintEvent(QPaintEvent*) {
  if (!m_state.place)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  QColor line = m_dark ? QColor(126, 190, 255) : QColor(18, 92, 156);
  if (m_state.held)
    line = m_dark ? QColor(255, 190, 92) : QColor(178, 84, 0);
  const QColor halo = m_dark ? QColor(16, 17, 19, 170) : QColor(255, 255, 255, 190);
  const QPointF middle(double(m_state.place->x), double(m_state.place->y));
  const auto ring = [&](double radius, Qt::PenStyle style, int alpha) {
    QColor ink = line;
    ink.setAlpha(alpha);
    painter.setPen(QPen(halo, nearThin + nearHalo));
    painter.drawEllipse(middle, radius, radius);
    painter.setPen(QPen(ink, nearThin, style));
    painter.drawEllipse(middle, radius, radius);
  };
  ring(ringRadius, Qt::SolidLine, 255);
  if (m_state.held)
    ring(double(m_state.reach), Qt::DashLine, 150);
  painter.setPen(Qt::NoPen);
  painter.setBrush(line);
  painter.drawEllipse(middle, 2.2, 2.2);
}

}  // namespace sline::widgets

#include "moc_near_mark.cpp"
