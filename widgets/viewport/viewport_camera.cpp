// SPDX-License-Identifier: Apache-2.0
// Moves the camera, at once or in flights.
#include <utility>

#include "model/scene/framing.h"
#include "model/scene/visible_structures.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

/// Milliseconds that a flight takes.
constexpr int flightTime = 220;
/// Milliseconds that a flight takes in which looks change: long enough to follow each change.
constexpr int travelTime = 700;

}  // namespace

void Viewport::keepMoving() {
  m_moving = true;
  m_rest.start();
  forgetName();
}

void Viewport::move(const model::Camera& camera) {
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  m_cutting = false;
  keepMoving();
  // The marks follow with the picture, because a software driver redraws the whole window to paint
  // them.
  refresh();
  emit cameraChanged();
}

void Viewport::rest() {
  m_moving = false;
  m_cutting = false;
  const bool arrived = std::exchange(m_arrived, false) && m_labels->arrive();
  // Of a picture that is not done yet one cannot know what it will lack.
  const bool lacks = m_last.makeshift || m_took != m_asked;
  if (arrived || lacks || !m_askedFineness.full() || m_labels->waits() || m_labels->outgrown())
    refresh();
}

void Viewport::stopFlight() {
  m_flight.reset();
  m_flightTick.stop();
  if (!m_blend)
    return;
  m_blend.reset();
  refresh();
}

double Viewport::flownPart() const {
  return double(m_flown.elapsed()) / double(m_flightTime);
}

void Viewport::startFlight(const model::Camera& camera, int milliseconds) {
  m_flight.emplace(m_camera, camera);
  m_flightTime = milliseconds;
  m_flown.start();
  m_flightTick.start();
}

void Viewport::travelTo(const model::Camera& camera, const model::Scene& from,
                        const model::Scene& to) {
  if (model::cameraFault(camera))
    return;
  m_pivot = camera.target;
  if (!m_flights || !isVisible()) {
    stopFlight();
    m_camera = camera;
    placeMarks();
    // The looks that will be the document's are shown at once, because there is no picture in
    // between.
    refresh(to);
    emit cameraChanged();
    return;
  }
  m_blend.emplace(from, to);
  startFlight(camera, travelTime);
  keepMoving();
}

void Viewport::setCamera(const model::Camera& camera) {
  stopFlight();
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  placeMarks();
  refresh();
  emit cameraChanged();
}

void Viewport::flyTo(const model::Camera& camera) {
  if (!m_flights || !isVisible() || camera == m_camera || model::cameraFault(camera)) {
    setCamera(camera);
    return;
  }
  stopFlight();
  startFlight(camera, flightTime);
}

void Viewport::flyOn() {
  if (!m_flight)
    return;
  const double part = flownPart();
  const model::Camera camera = m_flight->at(part);
  const bool looks = m_blend.has_value();
  if (part >= 1.0) {
    m_arrived = true;
    m_flight.reset();
    m_blend.reset();
    m_flightTick.stop();
  }
  if (looks && camera == m_camera) {
    keepMoving();
    refresh();
  }
  move(camera);
}

void Viewport::pivotToMiddle() {
  const model::Box bounds = shownScene().visibleBounds();
  if (!bounds.empty())
    m_pivot = bounds.centre();
}

void Viewport::setPivot(const glm::vec3& pivot) {
  m_pivot = pivot;
}

model::ZoomEnds Viewport::zoomEnds() const {
  return model::zoomEnds(shownScene().visibleBounds());
}

model::FreeSides Viewport::freeSides(const model::Scene& scene, const model::Camera& camera) const {
  return m_labels->sidesBeside(scene, camera);
}

model::Camera Viewport::fittedFrom(const model::Scene& scene, model::AnatomicalView view) const {
  const model::Camera there = model::anatomicalCamera(view, scene.visibleBounds(), aspect());
  return model::fittedView(scene, view, aspect(), freeSides(scene, there));
}

model::Camera Viewport::firstCamera(const model::Scene& scene) const {
  if (const std::optional<model::Camera> saved = savedOverview(scene))
    return withSides(*saved, aspect(), freeSides(scene, *saved));
  return fittedFrom(scene, model::AnatomicalView::anterior);
}

void Viewport::showFrom(model::AnatomicalView view) {
  pivotToMiddle();
  flyTo(fittedFrom(m_session.scene(), view));
}

void Viewport::viewFrom(const CubeDirection& from) {
  flyTo(turnedTo(m_camera, m_pivot, glm::vec3(from), upwardsFrom(from)));
}

void Viewport::fitAll() {
  fitTo({model::rootId});
}

void Viewport::fitTo(const NodeIds& ids) {
  const model::Box bounds = visibleBounds(m_session.scene(), ids);
  if (bounds.empty())
    return;
  m_pivot = bounds.centre();
  const model::Scene& scene = m_session.scene();
  flyTo(model::fittedToVisible(scene, m_camera, aspect(), freeSides(scene, m_camera), ids));
}

}  // namespace sline::widgets
