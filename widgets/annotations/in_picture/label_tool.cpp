// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/label_tool.h"

#include "model/edit/annotations.h"

namespace sline::widgets {

namespace {

/// Returns the way from the annotation's own place, the middle of a distance, to the middle of its
/// text, in heights of the picture.
glm::vec2 offsetIn(const LabelSheet& sheet, model::AnnotationId id) {
  const render::PlacedLabel* placed = sheet.plate.layout.find(id);
  for (const render::ShownLabel& label : sheet.plate.labels)
    if (placed && label.item.id == id) {
      glm::vec2 place(0.0f);
      for (const glm::vec2& each : label.item.places)
        place += each / float(label.item.places.size());
      const glm::vec2 base = label.item.base.value_or(place);
      return (placed->box.middle() - base) * sheet.wish.pixelsPerMm / sheet.wish.size.y;
    }
  return glm::vec2(0.0f);
}

}  // namespace

LabelTool::LabelTool(Session& session, const LabelLayer& layer, Surface surface, QObject* parent)
    : QObject(parent), m_session(session), m_layer(layer), m_surface(std::move(surface)) {}

std::optional<LabelGrip> LabelTool::gripAt(const glm::vec2& pixel) const {
  return m_layer.sheet() ? widgets::gripAt(*m_layer.sheet(), pixel) : std::nullopt;
}

const model::Annotation* LabelTool::before() const {
  return m_grip ? model::findAnnotation(m_session.sceneBeforePreview(), m_grip->id) : nullptr;
}

bool LabelTool::press(const Pointer& pointer) {
  const std::optional<LabelGrip> grip = gripAt(pointer.pixel);
  if (!grip || pointer.button != Qt::LeftButton || (pointer.keys & Qt::ShiftModifier) != 0 ||
      !model::findAnnotation(m_session.scene(), grip->id))
    return false;
  if (m_ending) {  // an answer is still on its way
    m_answered = m_asked;
    commit();
  }
  m_session.activateAnnotation(grip->id);
  m_grip = grip;
  m_pressed = pointer.pixel;
  m_offset = offsetIn(*m_layer.sheet(), grip->id);
  return true;
}

void LabelTool::move(const Pointer& pointer) {
  const model::Annotation* annotation = before();
  if (!annotation || annotation->locked)
    return;
  if (m_grip->place)
    movePlace(pointer);
  else
    moveText(pointer);
}

void LabelTool::show(const model::Annotation& annotation) {
  const model::Scene& scene = m_session.sceneBeforePreview();
  m_session.preview(model::withAnnotationChanged(scene, annotation.id, annotation).scene);
}

void LabelTool::moveText(const Pointer& pointer) {
  model::Annotation annotation = *before();
  annotation.offset = m_offset + (pointer.pixel - m_pressed) / pointer.size.y;
  show(annotation);
}

void LabelTool::movePlace(const Pointer& pointer) {
  m_surface(pointer.pixel, [this, number = ++m_asked](const std::vector<model::Anchor>& anchors) {
    const model::Annotation* annotation = before();
    // Answers come in the order of the questions; those for a drag that has ended are ignored.
    if (!annotation || number <= m_answered || number > m_asked)
      return;
    m_answered = number;
    if (!anchors.empty()) {
      model::Annotation moved = *annotation;
      if (moved.kind == model::AnnotationKind::distance)
        moved.anchors[*m_grip->place] = anchors.back();
      else
        moved.anchors = anchors;
      moved.found = false;  // a place that was set by hand stays
      show(moved);
    }
    if (m_ending && m_answered == m_asked)
      commit();
  });
}

void LabelTool::release(const Pointer&) {
  if (!m_grip)
    return;
  m_ending = m_answered < m_asked;
  if (!m_ending)
    commit();
}

void LabelTool::commit() {
  const bool text = !m_grip->place;
  m_grip.reset();
  m_ending = false;
  m_session.commitPreview(text ? tr("Move Label") : tr("Move What a Label Points At"));
}

void LabelTool::cancel() {
  if (!m_grip)
    return;
  m_grip.reset();
  m_ending = false;
  m_answered = m_asked;
  m_session.cancelPreview();
}

}  // namespace sline::widgets

#include "moc_label_tool.cpp"
