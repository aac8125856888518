// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/near_tool.h"

#include <QKeyEvent>
#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "model/camera/camera_moves.h"
#include "model/disk/process.h"
#include "model/geometry/sight.h"
#include "model/scene/visible_structures.h"

namespace sline::widgets {

namespace {

/// Tells whether one points at the structure itself rather than through it.
bool isSolid(const model::ResolvedStyle& style) {
  constexpr float told = 1.5f;  // suggestive contours appear
  return style.fill != model::Fill::none || style.gamma.value() >= told ||
         style.gammaMap.scalar != model::GammaScalar::none;
}

std::set<model::MeshPtr> shownMeshes(const model::Scene& scene) {
  std::set<model::MeshPtr> meshes;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    meshes.insert(structure.node->mesh);
  return meshes;
}

}  // namespace

NearTool::NearTool(Session& session, const ViewControl& view) : m_session(session), m_view(view) {
  m_pool.setMaxThreadCount(1);
  connect(&session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) {
            if (before.opening != now.opening) {
              m_trees = {};
              m_ready.clear();
              m_falloffMm.reset();
              setPlacing(false);
            }
            show(m_picture);
          });
}

NearTool::~NearTool() {
  m_pool.waitForDone();
}

void NearTool::showOver(QWidget& picture) {
  picture.installEventFilter(this);
  m_mark = new NearMark(&picture);
}

bool NearTool::eventFilter(QObject* watched, QEvent* event) {
  if (m_placing && !m_drag && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    cancel();
    return true;
  }
  return QObject::eventFilter(watched, event);
}

void NearTool::setDark(bool dark) {
  if (m_mark)
    m_mark->setDark(dark);
}

void NearTool::whenReady(std::function<void()> then) {
  const std::set<model::MeshPtr> meshes = shownMeshes(m_session.sceneBeforePreview());
  if (std::includes(m_ready.begin(), m_ready.end(), meshes.begin(), meshes.end()))
    return then();
  m_then = std::move(then);
  m_pool.clear();
  m_pool.start([this, meshes] {
    static thread_local const bool stoodBack = (model::standBack(), true);
    static_cast<void>(stoodBack);
    const auto trees = std::make_shared<std::vector<model::BvhPtr>>();
    for (const model::MeshPtr& mesh : meshes)
      trees->push_back(model::treeOf(mesh));
    QMetaObject::invokeMethod(this, [this, meshes, trees] {
      for (const model::MeshPtr& mesh : meshes)
        m_trees.of(mesh);  // shared with `trees` by now
      m_ready = meshes;
      if (const auto waiting = std::exchange(m_then, {}))
        waiting();
    });
  });
}

model::Edited NearTool::edited(const model::Scene& scene, const model::NearFocus& focus) {
  return model::withNearFocus(scene, focus,
                              model::structuresBefore(scene, focus, m_view.camera(), m_trees));
}

void NearTool::focusOn(const NodeIds& targets) {
  if (targets.empty())
    return;
  whenReady([this, targets] {
    const model::NearFocus focus{.targets = targets,
                                 .nearness = {.place = {}, .falloffMm = falloffMm()}};
    m_session.apply(tr("Focus by Nearness"), edited(m_session.sceneBeforePreview(), focus));
  });
}

void NearTool::setPlacing(bool placing) {
  if (placing)
    whenReady([] {});
  if (placing == m_placing)
    return;
  m_placing = placing;
  emit placingChanged(placing);
}

float NearTool::falloffMm() const {
  const auto& nearness = m_session.scene().focus().nearness;
  if (nearness)
    return nearness->falloffMm;
  return m_falloffMm ? *m_falloffMm : model::usualFalloffMm(m_session.scene());
}

void NearTool::dragFalloff(float millimetres) {
  auto focus = model::nearFocusOf(m_session.sceneBeforePreview());
  m_falloffMm = std::clamp(millimetres, model::nearnessFalloffs.low, model::nearnessFalloffs.high);
  if (!focus)
    return;
  focus->nearness.falloffMm = *m_falloffMm;
  whenReady([this, focus = *focus] {
    m_session.preview(edited(m_session.sceneBeforePreview(), focus).scene);
  });
}

void NearTool::finishFalloff() {
  if (busy())
    m_then = [this, then = std::move(m_then)] {
      then();
      finishFalloff();
    };
  else if (m_session.previewing())
    m_session.commitPreview(tr("Reach of Nearness"));
}

bool NearTool::near(const glm::vec2& pixel, const glm::vec2& size) const {
  const auto& nearness = m_session.scene().focus().nearness;
  if (!nearness || !nearness->place)
    return false;
  const auto at = pixelOf(m_view.camera(), *nearness->place, size);
  return at && glm::distance(*at, pixel) <= NearMark::grip;
}

bool NearTool::grips(const Pointer& pointer) const {
  return m_placing || near(pointer.pixel, pointer.size);
}

std::optional<Qt::CursorShape> NearTool::cursor(const Pointer& pointer) const {
  if (m_placing)
    return Qt::CrossCursor;
  return grips(pointer) ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void NearTool::show(const ShownPicture& picture) {
  m_picture = picture;
  if (!m_mark)
    return;
  m_mark->setGeometry(m_mark->parentWidget()->rect());
  const auto& nearness = m_session.scene().focus().nearness;
  NearMark::State state;
  if (nearness && nearness->place) {
    state.place = pixelOf(picture.camera, *nearness->place, picture.size);
    const float scale =
        model::millimetresPerPixel(picture.camera, *nearness->place, picture.size.y);
    state.reach = scale > 0.0f ? nearness->falloffMm / scale : 0.0f;
    state.held = dragging() || (picture.mouse && near(*picture.mouse, picture.size));
  }
  m_mark->show(state);
}

glm::vec3 NearTool::placeAt(const glm::vec2& pixel, const glm::vec2& size) {
  const model::Scene& scene = m_session.sceneBeforePreview();
  const model::Ray sight = sightThrough(m_view.camera(), pixel, size);
  std::optional<float> solid;
  std::optional<float> any;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const model::Node& node = *structure.node;
    if (!model::reaches(sight, node.mesh->bounds()))
      continue;
    std::vector<model::Plane> planes;
    for (const model::Section& section : scene.sectionsOf(node.id))
      planes.push_back(section.plane);
    const auto met = model::nearestKept(m_trees.of(node.mesh), sight, planes);
    if (!met)
      continue;
    any = std::min(any.value_or(met->hit.t), met->hit.t);
    if (isSolid(structure.style))
      solid = std::min(solid.value_or(met->hit.t), met->hit.t);
  }
  if (solid || any)
    return sight.origin + (solid ? *solid : *any) * sight.direction;
  const auto& nearness = scene.focus().nearness;
  const glm::vec3 before = nearness && nearness->place ? *nearness->place : m_view.pivot();
  return pointAtDepthOf(m_view.camera(), before, pixel, size);
}

bool NearTool::press(const Pointer& pointer) {
  const bool plain = (pointer.keys & (Qt::ControlModifier | Qt::AltModifier)) == 0;
  if (pointer.button != Qt::LeftButton || !plain || !grips(pointer))
    return false;
  m_drag = Drag{.pixel = pointer.pixel, .size = pointer.size};
  if (m_placing)
    whenReady([this] { follow(); });
  else
    m_place = *m_session.scene().focus().nearness->place;
  return true;
}

void NearTool::move(const Pointer& pointer) {
  if (!m_drag)
    return;
  const bool inDepth = (pointer.keys & Qt::ShiftModifier) != 0 && !m_placing;
  if (inDepth && !m_drag->inDepth) {
    m_drag->from = m_drag->pixel;
    m_drag->base = m_place;
  }
  m_drag->inDepth = inDepth;
  m_drag->pixel = pointer.pixel;
  whenReady([this] { follow(); });
}

void NearTool::follow() {
  if (!m_drag)
    return;
  if (m_drag->inDepth) {
    // Upwards is away from the eye.
    const float up = m_drag->from.y - m_drag->pixel.y;
    const float scale = model::millimetresPerPixel(m_view.camera(), m_drag->base, m_drag->size.y);
    m_place = m_drag->base - scale * up * model::towardsEye(m_view.camera(), m_drag->base);
  } else {
    m_place = placeAt(m_drag->pixel, m_drag->size);
  }
  const model::NearFocus focus{.targets = {},
                               .nearness = {.place = m_place, .falloffMm = falloffMm()}};
  m_session.preview(edited(m_session.sceneBeforePreview(), focus).scene);
  if (m_drag->released)
    finish();
}

void NearTool::release(const Pointer&) {
  if (!m_drag)
    return;
  if (busy())
    m_drag->released = true;
  else
    finish();
}

void NearTool::finish() {
  const bool placed = m_placing;
  m_drag.reset();
  if (m_session.previewing())
    m_session.commitPreview(placed ? tr("Nearness to a Place") : tr("Move the Place"));
  setPlacing(false);
  show(m_picture);
}

void NearTool::cancel() {
  m_then = {};
  if (m_drag && m_session.previewing())
    m_session.cancelPreview();
  m_drag.reset();
  setPlacing(false);
}

}  // namespace sline::widgets

#include "moc_near_tool.cpp"
