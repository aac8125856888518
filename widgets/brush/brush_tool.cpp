// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_tool.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "model/camera/camera_moves.h"
#include "model/edit/painting.h"
#include "model/geometry/sight.h"
#include "model/scene/resolved_styles.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

std::vector<model::Plane> planesThatCut(const model::Scene& scene, model::NodeId id) {
  std::vector<model::Plane> planes;
  for (const model::Section& section : scene.sectionsOf(id))
    planes.push_back(section.plane);
  return planes;
}

}  // namespace

BrushTool::BrushTool(Session& session, const ViewControl& view) : m_session(session), m_view(view) {
  const auto follow = [this] {
    if (m_active && !painting())
      prepare();
    show(m_picture);
  };
  connect(&session, &Session::selectionChanged, this, follow);
  connect(&session, &Session::documentChanged, this, follow);
}

void BrushTool::showOver(QWidget& picture) {
  m_mark = new BrushMark(&picture);
}

void BrushTool::setDark(bool dark) {
  if (m_mark)
    m_mark->setDark(dark);
}

void BrushTool::setActive(bool active) {
  if (active == m_active)
    return;
  if (!active)
    cancel();
  m_active = active;
  if (active) {
    prepare();
  } else {
    m_sights.forget();
    m_grounds = {};
    m_prepared.clear();
  }
  show(m_picture);
  emit activeChanged(active);
}

void BrushTool::setBrush(const Brush& brush) {
  Brush within = brush;
  within.radius = std::clamp(brush.radius, brushRadii.low, brushRadii.high);
  within.softness = std::clamp(brush.softness, 0.0f, 1.0f);
  within.strength = std::clamp(brush.strength, 0.0f, 1.0f);
  if (within == m_brush)
    return;
  m_brush = within;
  show(m_picture);
  emit brushChanged();
}

NodeIds BrushTool::targets() const {
  const model::Scene& scene = m_session.scene();
  NodeIds within = m_session.selection();
  if (within.empty()) {
    if (const NodeIds all = scene.structuresBelow(model::rootId); all.size() == 1)
      within = all;
  }
  NodeIds targets;
  for (const auto& [node, style] : model::resolvedBelow(scene, within))
    if (style.visible && node->mesh->triangleCount() > 0 && !scene.isLocked(node->id))
      targets.push_back(node->id);
  return targets;
}

void BrushTool::prepare() {
  std::set<model::MeshPtr> meshes;
  for (const model::NodeId id : targets())
    meshes.insert(m_session.scene().find(id)->mesh);
  if (meshes == m_prepared && m_grounds.valid())
    return;
  m_prepared = meshes;
  m_grounds = std::async(std::launch::async, [meshes, before = m_grounds] {
                Grounds grounds;
                const Grounds known = before.valid() ? before.get() : Grounds();
                for (const model::MeshPtr& mesh : meshes) {
                  const auto found = known.find(mesh);
                  grounds[mesh] = found != known.end() ? found->second : brushGround(mesh);
                }
                return grounds;
              }).share();
}

bool BrushTool::ready(bool wait) const {
  if (!m_grounds.valid())
    return false;
  if (wait)
    m_grounds.wait();
  return m_grounds.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::optional<BrushTool::Place> BrushTool::targetAt(const glm::vec2& pixel,
                                                    const glm::vec2& size) const {
  const model::Scene& scene = m_session.scene();
  const model::Ray sight = sightThrough(m_view.camera(), pixel, size);
  const bool known = ready(false);
  std::optional<Place> nearest;
  for (const model::NodeId id : targets()) {
    const model::Node& node = *scene.find(id);
    if (!model::reaches(sight, node.mesh->bounds()))
      continue;
    if (!known)
      return Place{.id = id};
    const auto ground = m_grounds.get().find(node.mesh);
    if (ground == m_grounds.get().end())
      continue;
    const auto planes = planesThatCut(scene, id);
    const auto met = model::nearestKept(*ground->second->tree, sight, planes);
    if (met && !met->cutFace && (!nearest || met->hit.t < nearest->distance))
      nearest = Place{.id = id, .distance = met->hit.t};
  }
  return nearest;
}

BrushSight::From BrushTool::sightOf(model::NodeId id, const glm::vec2& size) const {
  const model::Scene& scene = m_session.scene();
  return {.ground = m_grounds.get().at(scene.find(id)->mesh),
          .camera = m_view.camera(),
          .size = size,
          .planes = planesThatCut(scene, id)};
}

bool BrushTool::grips(const Pointer& pointer) const {
  return m_active && targetAt(pointer.pixel, pointer.size).has_value();
}

std::optional<Qt::CursorShape> BrushTool::cursor(const Pointer& pointer) const {
  return grips(pointer) ? std::optional(Qt::CrossCursor) : std::nullopt;
}

void BrushTool::show(const ShownPicture& picture) {
  m_picture = picture;
  if (!m_mark)
    return;
  m_mark->setGeometry(m_mark->parentWidget()->rect());
  if (!m_active)
    return m_mark->show({});
  Brush brush = m_brush;
  std::optional<glm::vec2> at = picture.mouse;
  bool onTarget = painting();
  if (painting()) {
    brush.erases = m_erases;
    at = m_path.empty() ? m_last : m_path.back();
  } else if (m_beside) {
    at = m_last;
  } else if (at) {
    const auto target = targetAt(*at, picture.size);
    onTarget = target.has_value();
    if (target && ready(false) && std::exchange(m_shownFrom, m_view.camera()) == m_view.camera())
      m_sights.want(sightOf(target->id, picture.size));
    const model::Ray sight = sightThrough(m_view.camera(), *at, picture.size);
    const float scale = target && ready(false)
                            ? model::millimetresPerPixel(
                                  m_view.camera(),
                                  sight.origin + target->distance * sight.direction, picture.size.y)
                            : 0.0f;
    if (std::exchange(m_millimetres, scale) != scale)
      emit brushChanged();
  }
  m_mark->show({.at = at, .brush = brush, .onTarget = onTarget});
}

bool BrushTool::press(const Pointer& pointer) {
  const bool plain = (pointer.keys & (Qt::ShiftModifier | Qt::AltModifier)) == 0;
  if (!m_active || pointer.button != Qt::LeftButton || !plain)
    return false;
  prepare();
  const bool control = (pointer.keys & Qt::ControlModifier) != 0;
  const Press press{
      .pixel = pointer.pixel, .size = pointer.size, .erases = m_brush.erases != control};
  finish();
  // The press is taken in any case: a hand that paints never means to turn the scene.
  m_last = press.pixel;
  if (!start(press))
    m_beside = press;
  return true;
}

bool BrushTool::start(const Press& press) {
  if (!targetAt(press.pixel, press.size))
    return false;
  m_beside.reset();
  m_erases = press.erases;
  m_last = press.pixel;
  m_path.clear();
  if (ready(false))
    return begin(press);
  m_awaited = press;
  return true;
}

bool BrushTool::begin(const Press& press) {
  m_awaited.reset();
  const auto target = targetAt(press.pixel, press.size);
  if (!target)
    return false;
  const model::Scene& scene = m_session.scene();
  const model::Node& node = *scene.find(target->id);
  m_target = target->id;
  Brush brush = m_brush;
  brush.erases = press.erases;
  m_stroke.emplace(m_sights.take(sightOf(target->id, press.size)), node.paint, brush);
  m_path.insert(m_path.begin(), press.pixel);
  m_last = press.pixel;
  follow();
  return true;
}

void BrushTool::follow() {
  if (!m_stroke)
    return;
  bool changed = false;
  for (const glm::vec2& to : std::exchange(m_path, {})) {
    changed = m_stroke->move(m_last, to) || changed;
    m_last = to;
  }
  if (changed)
    m_session.preview(
        model::withPaint(m_session.sceneBeforePreview(), m_target, m_stroke->paint()).scene);
}

void BrushTool::passes(const Pointer& pointer) {
  if (painting())
    m_path.push_back(pointer.pixel);
}

void BrushTool::move(const Pointer& pointer) {
  if (m_beside) {
    Press here = *m_beside;
    here.pixel = m_last = pointer.pixel;
    if (!start(here))
      show(m_picture);
  }
  if (m_awaited && ready(false))
    begin(*m_awaited);
  follow();
}

void BrushTool::release(const Pointer& pointer) {
  passes(pointer);
  if (m_awaited && ready(true))
    begin(*m_awaited);
  follow();
  if (m_stroke)
    m_session.commitPreview(stepName());
  finish();
}

void BrushTool::cancel() {
  if (m_stroke)
    m_session.cancelPreview();
  finish();
}

void BrushTool::finish() {
  m_beside.reset();
  m_stroke.reset();
  m_awaited.reset();
  m_path.clear();
}

QString BrushTool::stepName() const {
  const model::Node* node = m_session.scene().find(m_target);
  const QString name = node ? m_session.names().shown(node->name) : QString();
  return (m_erases ? tr("Erase on %1") : tr("Paint on %1")).arg(name);
}

}  // namespace sline::widgets

#include "moc_brush_tool.cpp"
