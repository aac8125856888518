// SPDX-License-Identifier: Apache-2.0
#include "render/web/page_engine.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/camera/camera_flight.h"
#include "model/camera/camera_moves.h"
#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/scene/framing.h"
#include "render/labels/anchors.h"
#include "render/labels/obstacles.h"
#include "render/lines/techniques/line_technique.h"
#include "render/vectors/structure_work.h"

namespace sline::render::web {

namespace {

constexpr float degreesPerPixel = 0.4f;

std::vector<glm::vec3> cornersOf(const model::Box& box) {
  const auto corners = box.corners();
  return {corners.begin(), corners.end()};
}

/// The line around what is selected.
Outline selectionOutline(std::vector<model::NodeId> structures, float ratio) {
  std::sort(structures.begin(), structures.end());
  Outline outline{.structures = std::move(structures), .ink = {37, 99, 235}};
  outline.width *= ratio;
  outline.casingWidth *= ratio;
  return outline;
}

LabelPost nearerSide(const LabelItem& item, const LabelBox& anatomy) {
  return item.places.front().x < anatomy.middle().x ? LabelPost::left : LabelPost::right;
}

/// Returns a label that had to go to the far side, past the anatomy's middle.
std::optional<model::AnnotationId> strayLabel(const LabelRequest& request,
                                              const LabelLayout& layout) {
  constexpr float beyond = 0.06f;  // of the anatomy's width, from its middle
  const LabelBox& anatomy = *request.obstacles.extent;
  for (const LabelItem& item : request.items) {
    const PlacedLabel* placed = layout.find(item.id);
    const float past = std::abs(item.places.front().x - anatomy.middle().x);
    const bool column =
        placed && (placed->post == LabelPost::left || placed->post == LabelPost::right);
    if (column && past > beyond * anatomy.size().x && placed->post != nearerSide(item, anatomy))
      return item.id;
  }
  return std::nullopt;
}

/// Turns rows from the bottom to rows from the top.
void turnOver(std::vector<std::uint32_t>& pixels, std::size_t row) {
  const std::size_t rows = pixels.size() / row;
  for (std::size_t y = 0; 2 * y + 1 < rows; ++y)
    std::swap_ranges(pixels.begin() + std::ptrdiff_t(y * row),
                     pixels.begin() + std::ptrdiff_t((y + 1) * row),
                     pixels.begin() + std::ptrdiff_t((rows - 1 - y) * row));
}

}  // namespace

Status PageEngine::take(std::string_view part) {
  TRY(m_unpacked.take(part));
  show();
  if (!m_hasCamera) {
    const auto overview = model::savedOverview(m_shown);
    const model::Camera first = !m_shown.views().empty() ? m_shown.views().front().camera
                                : overview
                                    ? *overview
                                    : model::anatomicalCamera(model::AnatomicalView::anterior,
                                                              m_shown.visibleBounds(), 4.0f / 3.0f);
    if (!m_shown.views().empty())
      goTo(0, 0.0);
    setCamera(model::withSides(first, aspect(), freeSides()));
  }
  return Unit{};
}

void PageEngine::setSize(const PageSize& size) {
  m_size = {std::max(size.width, 1), std::max(size.height, 1), std::max(size.ratio, 0.1f)};
}

glm::vec2 PageEngine::pageSize() const {
  return glm::vec2(m_size.width, m_size.height) / m_size.ratio;
}

model::FreeSides PageEngine::freeSides() const {
  // Labels stand beside the anatomy where there is width for them, as on paper; upright telephones
  // have none to give.
  constexpr double room = 0.17;
  const bool wide = aspect() >= 0.9f && !m_shown.annotations().empty();
  return wide ? model::FreeSides{.left = room, .right = room} : model::FreeSides{};
}

glm::vec3 PageEngine::pivot() const {
  const model::Box bounds = m_shown.visibleBounds();
  return bounds.empty() ? m_camera.target : bounds.centre();
}

void PageEngine::orbit(const glm::vec2& pixels) {
  setCamera(
      model::orbited(m_camera, pivot(), degreesPerPixel * pixels.x, degreesPerPixel * pixels.y));
}

void PageEngine::pan(const glm::vec2& pixels) {
  setCamera(model::panned(m_camera, pivot(), pixels, pageSize().y));
}

void PageEngine::roll(float degrees) {
  setCamera(model::rolled(m_camera, degrees));
}

void PageEngine::zoom(float factor, const glm::vec2& at) {
  const glm::vec3 place = model::pointAtDepthOf(m_camera, pivot(), at, pageSize());
  setCamera(model::zoomedWithin(m_camera, place, factor, model::zoomEnds(m_shown.visibleBounds())));
}

void PageEngine::fit(std::span<const model::NodeId> ids) {
  const model::Box bounds =
      ids.empty() ? m_shown.visibleBounds() : model::visibleBounds(m_shown, ids);
  if (!bounds.empty())
    setCamera(model::fitted(m_camera, cornersOf(bounds), aspect(), freeSides()));
}

void PageEngine::look(model::AnatomicalView from) {
  const model::Box bounds = m_shown.visibleBounds();
  const model::Camera camera = model::anatomicalCamera(from, bounds, aspect());
  setCamera(bounds.empty() ? camera
                           : model::fitted(camera, cornersOf(bounds), aspect(), freeSides()));
}

void PageEngine::setCamera(const model::Camera& camera) {
  if (model::cameraFault(camera))
    return;
  m_camera = camera;
  m_hasCamera = true;
}

void PageEngine::goTo(std::size_t view, double share) {
  const std::vector<model::View>& views = m_unpacked.scene().views();
  if (view >= views.size())
    return;
  if (share <= 0.0 || m_flyingTo != view) {
    m_flightFrom = m_camera;
    m_flyingTo = view;
    m_view = view;
    m_changes.clear();
    show();
  }
  if (share <= 0.0)
    return;
  const model::Camera to = model::withSides(views[view].camera, aspect(), freeSides());
  setCamera(model::CameraFlight(m_flightFrom, to).at(std::min(share, 1.0)));
  if (share >= 1.0)
    m_flyingTo.reset();
}

void PageEngine::setGamma(std::span<const model::NodeId> ids, float gamma) {
  change({{ids.begin(), ids.end()}, Gamma::clamped(gamma).value()});
}

float PageEngine::gamma(model::NodeId id) const {
  return m_shown.find(id) ? m_shown.resolve(id).gamma.value() : 0.0f;
}

void PageEngine::setVisible(std::span<const model::NodeId> ids, bool visible) {
  change({{ids.begin(), ids.end()}, visible});
}

bool PageEngine::visible(model::NodeId id) const {
  return model::visibilityOf(m_shown, id) != model::Visibility::none;
}

void PageEngine::resetLook() {
  m_changes.clear();
  show();
}

void PageEngine::change(Change change) {
  apply(change);
  // A slider that is drawn changes the same many times.
  const bool again = !m_changes.empty() && m_changes.back().ids == change.ids &&
                     m_changes.back().to.index() == change.to.index();
  if (again && std::holds_alternative<float>(change.to))
    m_changes.back() = std::move(change);
  else
    m_changes.push_back(std::move(change));
}

void PageEngine::apply(const Change& change) {
  std::vector<model::NodeId> there;
  for (const model::NodeId id : change.ids)
    if (m_shown.find(id))
      there.push_back(id);
  if (const bool* visible = std::get_if<bool>(&change.to)) {
    m_shown =
        (*visible ? model::withShown(m_shown, there) : model::withHidden(m_shown, there)).scene;
    return;
  }
  std::vector<model::NodeId> structures;
  for (const model::NodeId id : there)
    for (const model::NodeId below : m_shown.structuresBelow(id))
      structures.push_back(below);
  model::Style look;
  look.gamma = Gamma::clamped(std::get<float>(change.to));
  m_shown = model::withLook(m_shown, structures, look).scene;
}

void PageEngine::show() {
  m_shown = m_unpacked.scene();
  if (m_view && *m_view < m_shown.views().size())
    m_shown = model::withViewApplied(m_shown, m_shown.views()[*m_view]).scene;
  for (const Change& change : m_changes)
    apply(change);
}

void PageEngine::setLabels(std::vector<TextRoom> labels, bool seen) {
  m_rooms = std::move(labels);
  m_onlySeen = seen;
  m_layout = {};
}

model::Scene PageEngine::labelled(bool moving) const {
  model::Scene scene = m_shown;
  std::vector<model::Annotation> annotations = scene.annotations();
  for (model::Annotation& annotation : annotations) {
    const bool wanted = std::any_of(m_rooms.begin(), m_rooms.end(),
                                    [&](const TextRoom& room) { return room.id == annotation.id; });
    // Who turns the scene waits for no others to be looked for.
    const bool late = m_onlySeen && moving && !m_layout.find(annotation.id);
    annotation.visible = annotation.visible && wanted && !late;
  }
  scene.setAnnotations(std::move(annotations));
  return scene;
}

Status PageEngine::openPicture() {
  m_picture = TRY(Picture::create());
  m_plain = false;
  return Unit{};
}

void PageEngine::openPlainPicture() {
  m_picture = Picture::withoutDriver({}, {});
  m_plain = true;
}

PictureTarget PageEngine::target(const gpu::TextureSize& size) {
  if (m_plain) {
    m_pixels.resize(std::size_t(size.width) * std::size_t(size.height));
    return {size.width, size.height, m_pixels};
  }
  if (!m_canvas || m_canvas->size() != size)
    m_canvas = gpu::Target::display(size);
  return *m_canvas;
}

Result<bool> PageEngine::draw(bool moving) {
  const gpu::TextureSize size{m_size.width, m_size.height};
  PictureSettings settings{.width = size.width, .height = size.height};
  const Fineness fineness = moving ? m_quality.fineness() : Fineness{};
  settings.surfaceStep = fineness.surfaceStep;
  settings.hurried = moving;
  std::vector<Outline> outlines;
  if (!m_selected.empty())
    outlines.push_back(selectionOutline(m_selected, m_size.ratio));
  TRY(m_picture->drawInto({.target = target(size), .outlines = outlines}, m_shown, m_camera,
                          settings));
  if (m_plain)
    turnOver(m_pixels, std::size_t(size.width));
  m_judged =
      moving && m_picture->timings().layersDrawn > 0 ? std::optional(fineness) : std::nullopt;
  return !m_picture->timings().makeshift && fineness.full();
}

void PageEngine::took(double milliseconds) {
  if (const std::optional<Fineness> fineness = std::exchange(m_judged, std::nullopt))
    m_quality.took(milliseconds, *fineness);
}

std::vector<glm::vec3> PageEngine::segments() {
  KeptSurfaces surfaces;
  std::vector<StructureWork> work = structureWork(m_shown, surfaces);
  model::Box bounds;
  for (const StructureWork& one : work)
    bounds.add(one.shown.mesh->bounds());
  const PictureView view(m_camera, bounds, m_size.width, m_size.height);
  prepareLines(work);
  std::vector<glm::vec3> ends;
  for (const StructureWork& one : work) {
    const LineSet lines =
        styledLines(*one.shown.prepared, view, one.shown.style, one.shown.gammaOffsets.get());
    for (const LineTechnique& technique : lineTechniques())
      for (const Segment& segment : lines[technique.kind]) {
        ends.push_back(segment.a);
        ends.push_back(segment.b);
      }
  }
  return ends;
}

LabelLayout PageEngine::laidOut(LabelRequest& request, const LabelLayout* before) const {
  LabelLayout layout = render::layOutLabels(request, before);
  if (!m_onlySeen || request.moving || !request.obstacles.extent)
    return layout;
  while (const std::optional<model::AnnotationId> stray = strayLabel(request, layout)) {
    std::erase_if(request.items, [&](const LabelItem& item) { return item.id == *stray; });
    layout = render::layOutLabels(request, before);
  }
  return layout;
}

void PageEngine::layOutLabels(bool moving) {
  m_items.clear();
  if (m_rooms.empty()) {
    m_layout = {};
    return;
  }
  const Screen screen(m_camera, millimetres * pageSize());
  // After a large turn labels stand as if none had been before, or sides would stay.
  constexpr float another = 0.85f;  // cosine of its angle
  const glm::vec3 towardsEye = model::cameraFrame(m_camera).back;
  const bool turned = !moving && glm::dot(m_settled, towardsEye) < another;
  const bool follows = !m_layout.labels.empty() && !turned;
  if (!moving)
    m_settled = towardsEye;
  const LabelsInPicture found = labelsInPicture(labelled(moving), screen, {}, m_trees,
                                                {follows ? &m_layout : nullptr, moving});
  LabelRequest request{.items = {},
                       .space = {.size = screen.size()},
                       .obstacles = obstaclesOf(m_shown, screen),
                       .towardsEye = towardsEye,
                       .moving = moving};
  for (const ShownLabel& label : found.shown)
    for (const TextRoom& room : m_rooms)
      if (room.id == label.item.id &&
          (!m_onlySeen || (!label.item.hidden && request.items.size() < seenLabels))) {
        request.items.push_back(label.item);
        request.items.back().box = millimetres * room.box;
      }
  m_layout = laidOut(request, follows ? &m_layout : nullptr);
  m_items = std::move(request.items);
}

PageEngine::Pick PageEngine::pick(const glm::vec2& at) {
  Pick found;
  constexpr float dotReach = 1.0f;  // millimetres: a dot with the light rim around it
  for (const PlacedLabel& label : m_layout.labels) {
    const bool onDot = !label.hidden && !label.leader.empty() &&
                       glm::distance(label.leader.front(), millimetres * at) <= dotReach;
    if (onDot || label.box.contains(millimetres * at))
      found.label = label.id;
  }
  const std::vector<model::Ray> rays = sightsAround(m_camera, at, pageSize());
  if (const Picks picks = m_index.pick(m_shown, rays); picks.seen)
    found.structure = picks.seen->id;
  return found;
}

}  // namespace sline::render::web
