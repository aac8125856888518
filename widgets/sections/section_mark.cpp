// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_mark.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <glm/geometric.hpp>

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

constexpr double thin = 1.3;       ///< pixels: the outline
constexpr double haloWidth = 2.4;  ///< pixels around each line, which sets it off from the drawing

}  // namespace

SectionMark::SectionMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sectionMark"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void SectionMark::show(State state) {
  m_state = std::move(state);
  setVisible(m_state.handles.has_value());
  setAccessibleName(m_state.readout);
  update();
}

void SectionMark::setDark(bool dark) {
  m_dark = dark;
  update();
}

QColor SectionMark::ink(bool held) const {
  if (m_dark)
    return held ? QColor(255, 190, 92) : QColor(126, 190, 255);
  return held ? QColor(178, 84, 0) : QColor(18, 92, 156);
}

QColor SectionMark::halo() const {
  return m_dark ? QColor(16, 17, 19, 170) : QColor(255, 255, 255, 190);
}

void SectionMark::paintOutline(QPainter& painter) const {
  QPolygonF outline;
  for (const glm::vec2& p : m_state.handles->outline)
    outline << point(p);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(halo(), thin + haloWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolygon(outline);
  QColor line = ink(false);
  line.setAlpha(200);
  painter.setPen(QPen(line, thin, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolygon(outline);
}

void SectionMark::paintRing(QPainter& painter, const glm::vec2& at, SectionGrip grip) const {
  constexpr double radius = 5.0;
  const bool held = m_state.grip == grip;
  painter.setBrush(halo());
  painter.setPen(QPen(halo(), 2.0 + haloWidth));
  painter.drawEllipse(point(at), radius, radius);
  painter.setPen(QPen(ink(held), held ? 2.4 : 1.8));
  painter.drawEllipse(point(at), radius, radius);
}

void SectionMark::paintArrow(QPainter& painter) const {
  const SectionHandles& handles = *m_state.handles;
  const bool slides = m_state.grip == SectionGrip::slide;
  const bool flips = m_state.grip == SectionGrip::flip;
  const glm::vec2 way = glm::normalize(handles.tip - handles.slide);
  const glm::vec2 side(-way.y, way.x);
  constexpr float head = 11.0f;
  QPainterPath shaft(point(handles.slide));
  shaft.lineTo(point(handles.tip - 0.6f * head * way));
  QPolygonF triangle;
  if (handles.endOn)  // the arrow's direction cannot be shown: two heads, for the two sides
    triangle << point(handles.tip - 0.75f * head * glm::vec2(0, 1))
             << point(handles.tip + 0.55f * head * glm::vec2(1, 0))
             << point(handles.tip + 0.75f * head * glm::vec2(0, 1))
             << point(handles.tip - 0.55f * head * glm::vec2(1, 0));
  else
    triangle << point(handles.tip + 0.5f * head * way)
             << point(handles.tip - 0.5f * head * way + 0.55f * head * side)
             << point(handles.tip - 0.5f * head * way - 0.55f * head * side);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(halo(), 2.2 + haloWidth, Qt::SolidLine, Qt::RoundCap));
  painter.drawPath(shaft);
  painter.drawPolygon(triangle);
  painter.setPen(QPen(ink(slides), slides ? 2.6 : 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawPath(shaft);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink(flips));
  painter.drawPolygon(triangle);
  constexpr double foot = 6.0;
  painter.setPen(QPen(halo(), haloWidth));
  painter.setBrush(ink(slides));
  painter.drawEllipse(point(handles.slide), foot, foot);
}

void SectionMark::paintReadout(QPainter& painter) const {
  if (m_state.readout.isEmpty())
    return;
  const QFontMetrics metrics(font());
  QRectF box(0, 0, metrics.horizontalAdvance(m_state.readout) + 14, metrics.height() + 6);
  box.moveBottomLeft(point(m_state.handles->slide) + QPointF(16, -14));
  box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, width() - box.width() - 4.0)));
  box.moveTop(std::clamp(box.top(), 4.0, std::max(4.0, height() - box.height() - 4.0)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_dark ? QColor(236, 236, 236, 235) : QColor(38, 38, 40, 225));
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(m_dark ? QColor(20, 20, 22) : QColor(255, 255, 255));
  painter.drawText(box, Qt::AlignCenter, m_state.readout);
}

void SectionMark::paintEvent(QPaintEvent*) {
  if (!m_state.handles)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintOutline(painter);
  if (m_state.handles->turnAboutU)
    paintRing(painter, *m_state.handles->turnAboutU, SectionGrip::turnAboutU);
  if (m_state.handles->turnAboutV)
    paintRing(painter, *m_state.handles->turnAboutV, SectionGrip::turnAboutV);
  paintArrow(painter);
  paintReadout(painter);
}

}  // namespace sline::widgets

#include "moc_section_mark.cpp"
