// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/tools/box_tool.h"

#include <utility>

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

BoxTool::BoxTool(QWidget& picture, const CameraTool& camera, Drawn drawn)
    : m_picture(picture), m_camera(camera), m_drawn(std::move(drawn)) {}

bool BoxTool::press(const Pointer& pointer) {
  const bool plain = pointer.keys == Qt::NoModifier || pointer.keys == Qt::ControlModifier;
  const bool free = plain && !dragOf(m_camera.preset(), pointer.button, pointer.keys);
  if (pointer.button != Qt::LeftButton || (!m_armed && !free))
    return false;
  m_from = pointer.pixel;
  return true;
}

QRect BoxTool::area(const Pointer& pointer) const {
  return QRectF(point(m_from), point(pointer.pixel))
      .normalized()
      .toAlignedRect()
      .intersected(m_picture.rect());
}

void BoxTool::move(const Pointer& pointer) {
  // The band is made anew each time, because it is a child of the picture, which outlives the tool.
  if (!m_band) {
    m_band = std::make_unique<QRubberBand>(QRubberBand::Rectangle, &m_picture);
    m_band->setObjectName(QStringLiteral("selectionBox"));
  }
  m_band->setGeometry(area(pointer));
  m_band->show();
}

void BoxTool::release(const Pointer& pointer) {
  if (!m_band)
    return;
  m_band.reset();
  m_armed = false;
  m_drawn({.area = area(pointer),
           .touching = pointer.pixel.x < m_from.x,
           .adding = (pointer.keys & (Qt::ControlModifier | Qt::ShiftModifier)) != 0});
}

void BoxTool::cancel() {
  m_band.reset();
  m_armed = false;
}

std::optional<Qt::CursorShape> BoxTool::cursor(const Pointer&) const {
  return m_armed ? std::optional(Qt::CrossCursor) : std::nullopt;
}

}  // namespace sline::widgets
