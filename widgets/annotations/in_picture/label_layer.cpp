// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/label_layer.h"

#include <QPainter>
#include <glm/geometric.hpp>

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

constexpr float placeReach = 7.0f;  ///< pixels by which a press may miss a place
constexpr float boxReach = 2.0f;    ///< pixels by which it may miss a text

}  // namespace

std::optional<LabelGrip> gripAt(const LabelSheet& sheet, const glm::vec2& pixel) {
  const float scale = sheet.wish.pixelsPerMm;
  std::optional<LabelGrip> grip;
  float nearest = placeReach;
  for (const render::ShownLabel& label : sheet.plate.labels) {
    if (!sheet.plate.layout.find(label.item.id))
      continue;
    for (std::size_t i = 0; i < label.item.places.size(); ++i)
      if (const float away = glm::length(scale * label.item.places[i] - pixel); away < nearest) {
        nearest = away;
        grip = LabelGrip{label.item.id, i};
      }
  }
  if (grip)
    return grip;
  for (const render::PlacedLabel& label : sheet.plate.layout.labels)
    if (label.box.grown(boxReach / scale).contains(pixel / scale))
      return LabelGrip{label.id, std::nullopt};
  return std::nullopt;
}

QRectF boxOf(const LabelSheet& sheet, model::AnnotationId id) {
  const render::PlacedLabel* label = sheet.plate.layout.find(id);
  const float scale = sheet.wish.pixelsPerMm;
  return label ? QRectF(point(scale * label->box.low), point(scale * label->box.high)) : QRectF();
}

LabelLayer::LabelLayer(QWidget* picture) : QWidget(picture) {
  setObjectName(QStringLiteral("labelLayer"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void LabelLayer::show(LabelSheetPtr sheet) {
  const bool was = m_sheet != nullptr;
  m_sheet = sheet && !sheet->empty() ? std::move(sheet) : nullptr;
  if (was || m_sheet)
    showState();
}

void LabelLayer::mark(const Marks& marks) {
  if (marks == m_marks)
    return;
  m_marks = marks;
  showState();
}

void LabelLayer::showState() {
  setVisible(m_sheet || m_marks.begun);
  update();
}

void LabelLayer::frame(QPainter& painter, model::AnnotationId id, bool active) const {
  constexpr qreal air = 2.0;
  const QRectF box = boxOf(*m_sheet, id).adjusted(-air, -air, air, air);
  if (box.width() <= 2.0 * air)
    return;
  const bool dark = m_sheet->wish.style.ground == render::Background::dark;
  QColor ink = dark ? QColor(126, 190, 255) : QColor(18, 92, 156);
  painter.setBrush(QColor(ink.red(), ink.green(), ink.blue(), active ? 34 : 18));
  ink.setAlpha(active ? 255 : 120);
  painter.setPen(QPen(ink, active ? 1.4 : 1.0));
  painter.drawRoundedRect(box, 3.0, 3.0);
  if (!active)
    return;
  painter.setBrush(Qt::NoBrush);
  for (const render::ShownLabel& label : m_sheet->plate.labels)
    if (label.item.id == id)
      for (const glm::vec2& place : label.item.places)
        painter.drawEllipse(point(m_sheet->wish.pixelsPerMm * place), 5.5, 5.5);
}

void LabelLayer::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // Until a picture of another size is drawn the one before fills it, and no place is where it was.
  const glm::vec2 size(float(parentWidget()->width()), float(parentWidget()->height()));
  if (m_sheet && m_sheet->wish.size == size) {
    painter.drawImage(m_sheet->corner, m_sheet->image);
    if (m_marks.active)
      frame(painter, *m_marks.active, true);
    if (m_marks.hovered && m_marks.hovered != m_marks.active)
      frame(painter, *m_marks.hovered, false);
  }
  if (!m_marks.begun)
    return;
  const QColor ink(18, 92, 156);
  if (m_marks.mouse) {
    painter.setPen(QPen(QColor(255, 255, 255, 190), 3.6));
    painter.drawLine(point(*m_marks.begun), point(*m_marks.mouse));
    painter.setPen(QPen(ink, 1.4, Qt::DashLine));
    painter.drawLine(point(*m_marks.begun), point(*m_marks.mouse));
  }
  painter.setPen(QPen(Qt::white, 1.6));
  painter.setBrush(ink);
  painter.drawEllipse(point(*m_marks.begun), 4.0, 4.0);
}

}  // namespace sline::widgets

#include "moc_label_layer.cpp"
