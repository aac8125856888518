// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_handles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "model/camera/camera_moves.h"
#include "render/lettering/scale_length.h"

namespace sline::widgets {

namespace {

constexpr float arrowLength = 40.0f;  ///< pixels
constexpr float reach = 11.0f;        ///< pixels by which a press may miss a grip
constexpr float border = 14.0f;       ///< pixels: grips nearer to the picture's edge are moved in
constexpr float frameMargin = 1.06f;  ///< a factor on the rectangle around what is cut
/// The sine of the angle between the line of sight and a direction below which that is too short on
/// screen to drag along.
constexpr float endOnSine = 0.26f;

using Polygon = std::vector<glm::vec3>;

/// Returns the part of a polygon in front of the eye (Sutherland and Hodgman 1974).
Polygon inFront(const Polygon& polygon, const model::Camera& camera) {
  if (camera.projection == model::Projection::orthographic)
    return polygon;
  const glm::vec3 forward = -model::cameraFrame(camera).back;
  const float nearest = 1e-3f * glm::length(camera.eye - camera.target);
  const auto depth = [&](const glm::vec3& p) {
    return glm::dot(p - camera.eye, forward) - nearest;
  };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3& a = polygon[i];
    const glm::vec3& b = polygon[(i + 1) % polygon.size()];
    const float da = depth(a);
    const float db = depth(b);
    if (da >= 0.0f)
      kept.push_back(a);
    if ((da >= 0.0f) != (db >= 0.0f))
      kept.push_back(a + da / (da - db) * (b - a));
  }
  return kept;
}

/// Returns the part of a polygon on screen within the picture, some way from its edges.
std::vector<glm::vec2> withinPicture(std::vector<glm::vec2> polygon, const glm::vec2& size) {
  for (int edge = 0; edge < 4; ++edge) {
    const int axis = edge / 2;
    const auto room = [&](const glm::vec2& p) {
      return edge % 2 == 0 ? p[axis] - border : size[axis] - border - p[axis];
    };
    std::vector<glm::vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::vec2& a = polygon[i];
      const glm::vec2& b = polygon[(i + 1) % polygon.size()];
      const float ra = room(a);
      const float rb = room(b);
      if (ra >= 0.0f)
        kept.push_back(a);
      if ((ra >= 0.0f) != (rb >= 0.0f))
        kept.push_back(a + ra / (ra - rb) * (b - a));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

bool inPicture(const std::optional<glm::vec2>& p, const glm::vec2& size, float by = border) {
  return p && p->x >= by && p->y >= by && p->x <= size.x - by && p->y <= size.y - by;
}

/// Returns the place of the arrow: in the middle of the upper edge, or as far up as the picture
/// reaches.
std::optional<glm::vec2> footOf(const SectionFrame& frame, const model::Camera& camera,
                                const glm::vec2& size) {
  constexpr int steps = 50;
  constexpr float letters = 38.0f;  // pixels: the room of the letters at the picture's edges
  for (int i = steps; i >= -steps; --i) {
    const float part = float(i) / float(steps);
    const auto at = pixelOf(camera, frame.centre + part * frame.halfV * frame.v, size);
    if (inPicture(at, size, letters))
      return at;
  }
  return std::nullopt;
}

glm::vec2 middle(const std::vector<glm::vec2>& points) {
  glm::vec2 sum(0.0f);
  for (const glm::vec2& p : points)
    sum += p;
  return sum / float(points.size());
}

/// Returns how a small step from a point is seen, scaled up to the length of `way`; pixels.
glm::vec2 onScreen(const SectionDrag::Start& s, const glm::vec3& at, const glm::vec3& way) {
  constexpr float small = 1e-2f;
  const auto a = pixelOf(s.camera, at, s.size);
  const auto b = pixelOf(s.camera, at + small * way, s.size);
  return a && b ? (*b - *a) / small : glm::vec2(0.0f);
}

/// Returns where the line comes nearest to the ray, in units of its direction.
double alongLine(const glm::vec3& at, const glm::vec3& direction, const model::Ray& ray) {
  const glm::dvec3 d(direction);
  const glm::dvec3 r(ray.direction);
  const glm::dvec3 way = glm::dvec3(ray.origin) - glm::dvec3(at);
  const double c = glm::dot(d, r);
  return (glm::dot(way, d) - c * glm::dot(way, r)) / (1.0 - c * c);
}

}  // namespace

SectionFrame sectionFrame(const model::Plane& plane, const model::Box& bounds) {
  SectionFrame frame{.plane = plane};
  const model::PlaneAxes axes = model::axesOf(plane);
  frame.u = glm::vec3(axes.u);
  frame.v = glm::vec3(axes.v);
  const glm::vec3 half = bounds.empty() ? glm::vec3(50.0f) : 0.5f * bounds.size();
  const glm::vec3 centre = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
  const auto extent = [&](const glm::vec3& d) { return glm::dot(glm::abs(d), half); };
  frame.centre = centre - float(plane.distance(centre)) * plane.normal;
  frame.halfU = frameMargin * extent(frame.u);
  frame.halfV = frameMargin * extent(frame.v);
  const float along = glm::dot(plane.normal, centre);
  frame.lowest = along - extent(plane.normal);
  frame.highest = along + extent(plane.normal);
  return frame;
}

std::optional<SectionHandles> sectionHandles(const SectionFrame& frame, const model::Camera& camera,
                                             const glm::vec2& size) {
  const glm::vec3 u = frame.halfU * frame.u;
  const glm::vec3 v = frame.halfV * frame.v;
  const glm::vec3& c = frame.centre;
  SectionHandles handles;
  for (const glm::vec3& p : inFront({c - u - v, c + u - v, c + u + v, c - u + v}, camera))
    if (const auto pixel = pixelOf(camera, p, size))
      handles.outline.push_back(*pixel);
  const std::vector<glm::vec2> seen = withinPicture(handles.outline, size);
  if (seen.empty())
    return std::nullopt;
  handles.slide = footOf(frame, camera, size).value_or(middle(seen));

  const model::CameraFrame axes = model::cameraFrame(camera);
  const glm::vec3 sight = sightThrough(camera, handles.slide, size).direction;
  const glm::vec3& n = frame.plane.normal;
  const glm::vec3 across = n - glm::dot(n, sight) * sight;
  const glm::vec2 direction(glm::dot(across, axes.right), -glm::dot(across, axes.up));
  handles.endOn = glm::length(across) < endOnSine;
  const float length = std::max(0.45f, glm::length(across)) * arrowLength;
  // Seen along its normal, the arrow stands beside the ring so that its head can still be hit.
  handles.tip = handles.slide + (handles.endOn ? glm::vec2(0.6f * arrowLength, 0.0f)
                                               : length * glm::normalize(direction));
  const auto right = pixelOf(camera, c + u, size);
  if (inPicture(right, size))
    handles.turnAboutV = right;
  const auto below = pixelOf(camera, c - v, size);
  if (inPicture(below, size))
    handles.turnAboutU = below;
  return handles;
}

SectionGrip gripAt(const SectionHandles& handles, const glm::vec2& pixel) {
  SectionGrip grip = SectionGrip::none;
  float nearest = reach;
  const auto offer = [&](const std::optional<glm::vec2>& place, SectionGrip which) {
    const float distance = place ? glm::length(*place - pixel) : nearest;
    if (distance < nearest) {
      nearest = distance;
      grip = which;
    }
  };
  offer(handles.slide, SectionGrip::slide);
  offer(0.55f * handles.slide + 0.45f * handles.tip, SectionGrip::slide);
  offer(handles.tip, SectionGrip::flip);
  offer(handles.turnAboutU, SectionGrip::turnAboutU);
  offer(handles.turnAboutV, SectionGrip::turnAboutV);
  return grip;
}

double SectionDrag::slideAt(const glm::vec2& pixel) const {
  const SectionFrame& frame = m_start.frame;
  const glm::vec3& n = frame.plane.normal;
  const model::Ray from = sightThrough(m_start.camera, m_start.pixel, m_start.size);
  // The held point of the plane follows the mouse along the normal.
  const float slope = glm::dot(from.direction, n);
  if (std::abs(slope) > std::sqrt(1.0f - endOnSine * endOnSine)) {
    // Seen along the normal the point cannot follow: dragging upwards moves it away from the eye.
    const glm::vec3 held =
        pointAtDepthOf(m_start.camera, frame.centre, m_start.pixel, m_start.size);
    const float scale = model::millimetresPerPixel(m_start.camera, held, m_start.size.y);
    return double(scale * (m_start.pixel.y - pixel.y)) * (slope > 0.0f ? 1.0 : -1.0);
  }
  const glm::vec3 held = pointAtDepthOf(m_start.camera, frame.centre + frame.halfV * frame.v,
                                        m_start.pixel, m_start.size);
  const model::Ray to = sightThrough(m_start.camera, pixel, m_start.size);
  return alongLine(held, n, to) - alongLine(held, n, from);
}

double SectionDrag::turnAt(const glm::vec2& pixel, bool snap) const {
  const SectionFrame& frame = m_start.frame;
  const bool aboutU = m_start.grip == SectionGrip::turnAboutU;
  const glm::vec3 arm = aboutU ? -frame.halfV * frame.v : frame.halfU * frame.u;
  const glm::vec3 axis = aboutU ? frame.u : frame.v;
  const glm::vec3 held = frame.centre + arm;
  // The tangent is the direction in which the ring begins to move when the plane turns by a
  // positive angle.
  const glm::vec3 tangent = glm::cross(axis, arm);
  const glm::vec2 along = onScreen(m_start, held, tangent);
  const glm::vec2 outwards = onScreen(m_start, held, arm);
  const glm::vec2 way = pixel - m_start.pixel;
  double angle = 0.0;
  if (glm::length(along) > 2.0f * endOnSine * glm::length(outwards)) {
    angle = double(glm::dot(way, along) / glm::dot(along, along));
  } else if (glm::length(outwards) > 0.0f) {
    // Seen along its normal the ring only comes nearer to the middle, so it is taken to move away
    // from the eye.
    const glm::vec3 towards = model::towardsEye(m_start.camera, held);
    const double sign = glm::dot(tangent, towards) > 0.0f ? -1.0 : 1.0;
    angle = -sign * std::numbers::pi / 2.0 *
            double(glm::dot(way, outwards) / glm::dot(outwards, outwards));
  }
  double degrees = glm::degrees(angle);
  constexpr double step = 15.0;
  if (snap)
    degrees = step * std::round(degrees / step);
  return std::clamp(degrees, -180.0, 180.0);
}

model::Plane SectionDrag::at(const glm::vec2& pixel, bool snap) const {
  const SectionFrame& frame = m_start.frame;
  model::Plane plane = frame.plane;
  if (m_start.grip == SectionGrip::slide) {
    double offset = double(plane.offset) + slideAt(pixel);
    const double step =
        render::roundStep(0.02 * std::max(1e-3, double(frame.highest - frame.lowest)));
    if (snap)
      offset = step * std::round(offset / step);
    // A plane that was outside already is not pulled in by the first touch.
    plane.offset = std::clamp(float(offset), std::min(frame.lowest, plane.offset),
                              std::max(frame.highest, plane.offset));
  } else if (m_start.grip == SectionGrip::turnAboutU || m_start.grip == SectionGrip::turnAboutV) {
    const glm::vec3 axis = m_start.grip == SectionGrip::turnAboutU ? frame.u : frame.v;
    const double angle = glm::radians(turnAt(pixel, snap));
    const glm::dvec3 normal =
        glm::normalize(glm::angleAxis(angle, glm::dvec3(axis)) * glm::dvec3(plane.normal));
    plane.normal = glm::vec3(normal);
    plane.offset = float(glm::dot(normal, glm::dvec3(frame.centre)));
  }
  return plane;
}

}  // namespace sline::widgets
