// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_tool.h"

#include <QLocale>
#include <glm/geometric.hpp>

#include "model/edit/sections.h"
#include "widgets/sections/section_position.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

bool turns(SectionGrip grip) {
  return grip == SectionGrip::turnAboutU || grip == SectionGrip::turnAboutV;
}

}  // namespace

SectionTool::SectionTool(Session& session, const ViewControl& view)
    : m_session(session), m_view(view) {
  connect(&session, &Session::activeSectionChanged, this, [this] { show(m_picture); });
}

void SectionTool::showOver(QWidget& picture) {
  m_mark = new SectionMark(&picture);
  m_mark->lower();
}

void SectionTool::setDark(bool dark) {
  if (m_mark)
    m_mark->setDark(dark);
}

void SectionTool::show(const ShownPicture& picture) {
  m_picture = picture;
  if (!m_mark)
    return;
  m_mark->setGeometry(m_mark->parentWidget()->rect());
  const auto there = handles(picture.size, picture.camera);
  const SectionGrip under =
      there && picture.mouse ? widgets::gripAt(*there, *picture.mouse) : SectionGrip::none;
  m_mark->show({.handles = there,
                .grip = dragging() ? m_grip : under,
                .dragging = dragging(),
                .readout = m_readout});
}

bool SectionTool::grips(const Pointer& pointer) const {
  return gripAt(pointer) != SectionGrip::none;
}

std::optional<Qt::CursorShape> SectionTool::cursor(const Pointer& pointer) const {
  return grips(pointer) ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

const model::Section* SectionTool::active() const {
  const auto id = m_session.activeSection();
  for (const model::Section& section : m_session.scene().sections())
    if (section.id == id && section.enabled)
      return &section;
  return nullptr;
}

std::optional<SectionHandles> SectionTool::handles(const glm::vec2& size,
                                                   const model::Camera& camera) const {
  const model::Section* section = active();
  if (!section)
    return std::nullopt;
  const model::Box bounds = m_session.scene().visibleBounds(section->scope);
  return sectionHandles(sectionFrame(section->plane, bounds), camera, size);
}

SectionGrip SectionTool::gripAt(const Pointer& pointer) const {
  const auto there = handles(pointer.size);
  return there ? widgets::gripAt(*there, pointer.pixel) : SectionGrip::none;
}

bool SectionTool::press(const Pointer& pointer) {
  const bool plain = (pointer.keys & (Qt::ShiftModifier | Qt::AltModifier)) == 0;
  const model::Section* section = active();
  if (!section || pointer.button != Qt::LeftButton || !plain)
    return false;
  m_grip = gripAt(pointer);
  if (m_grip == SectionGrip::none)
    return false;
  m_before = *section;
  m_pressed = pointer.pixel;
  const model::Box bounds = m_session.scene().visibleBounds(section->scope);
  m_drag.emplace(SectionDrag::Start{
      // Dragging the head moves the plane as the arrow does.
      .grip = m_grip == SectionGrip::flip ? SectionGrip::slide : m_grip,
      .pixel = pointer.pixel,
      .frame = sectionFrame(section->plane, bounds),
      .camera = m_view.camera(),
      .size = pointer.size});
  return true;
}

void SectionTool::move(const Pointer& pointer) {
  if (!m_drag)
    return;
  constexpr float still = 4.0f;  // pixels by which a hand may shake in a click
  if (m_grip == SectionGrip::flip) {
    if (glm::length(pointer.pixel - m_pressed) < still)
      return;
    m_grip = SectionGrip::slide;
  }
  const bool snap = (pointer.keys & Qt::ControlModifier) != 0;
  model::Section section = *m_before;
  section.plane = m_drag->at(pointer.pixel, snap);
  m_readout = turns(m_grip)
                  ? tr("%1°").arg(QLocale().toString(m_drag->turnAt(pointer.pixel, snap), 'f', 0))
                  : positionText(section.plane, m_session.scene());
  const model::Scene& before = m_session.sceneBeforePreview();
  m_session.preview(model::withSectionChanged(before, section.id, section).scene);
}

void SectionTool::release(const Pointer&) {
  if (!m_drag)
    return;
  if (m_grip == SectionGrip::flip) {
    model::Section section = *m_before;
    section.plane = flipped(section.plane);
    m_session.apply(tr("Flip Section"),
                    model::withSectionChanged(m_session.scene(), section.id, section));
  } else {
    m_session.commitPreview(turns(m_grip) ? tr("Tilt Section") : tr("Move Section"));
  }
  finish();
}

void SectionTool::cancel() {
  if (!m_drag)
    return;
  m_session.cancelPreview();
  finish();
}

void SectionTool::finish() {
  m_drag.reset();
  m_before.reset();
  m_grip = SectionGrip::none;
  m_readout.clear();
}

}  // namespace sline::widgets

#include "moc_section_tool.cpp"
