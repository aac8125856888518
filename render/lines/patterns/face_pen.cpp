// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/face_pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

FacePen::FacePen(const model::Plane& plane, const FaceField& field, double margin)
    : m_field(field),
      m_margin(margin),
      m_origin(double(plane.offset) * glm::dvec3(plane.normal)),
      m_normal(plane.normal) {
  const model::PlaneAxes axes = model::axesOf(plane);
  m_u = axes.u;
  m_v = axes.v;
}

void FacePen::add(const glm::dvec2& at, float halfWidth) {
  m_drawn.points.push_back({.position = glm::vec3(m_origin + at.x * m_u + at.y * m_v),
                            .normal = m_normal,
                            .halfWidth = halfWidth});
}

void FacePen::end() {
  const auto count = std::uint32_t(m_drawn.points.size()) - m_first;
  if (count == 1)
    m_drawn.points.pop_back();
  else if (count > 1)
    m_drawn.strokes.push_back({.seed = {},
                               .seedPosition = m_drawn.points[m_first].position,
                               .first = m_first,
                               .count = count});
  m_first = std::uint32_t(m_drawn.points.size());
}

void FacePen::curve(std::span<const glm::dvec2> points, const MarkWidth& width) {
  const auto last = double(points.size() - 1);
  const auto widthAt = [&](double where) {
    const double fromEnd = std::min(where, last - where) / std::max(0.5 * last, 1e-9);
    return width.middle * float(glm::mix(double(width.ends), 1.0, std::min(1.0, 2.0 * fromEnd)));
  };
  double before = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double room = m_field.rim(points[i]) - m_margin;
    if (i > 0 && (room < 0.0) != (before < 0.0)) {
      const double t = before / (before - room);
      add(glm::mix(points[i - 1], points[i], t), widthAt(double(i) - 1.0 + t));
      if (room < 0.0)
        end();
    }
    if (room >= 0.0)
      add(points[i], widthAt(double(i)));
    before = room;
  }
  end();
}

void FacePen::loop(std::vector<glm::dvec2> points, const MarkWidth& width) {
  points.push_back(points.front());
  curve(points, width);
}

void FacePen::dot(const glm::dvec2& at, float halfWidth) {
  if (m_field.rim(at) < m_margin)
    return;
  add(at, halfWidth);
  m_drawn.strokes.push_back(
      {.seed = {}, .seedPosition = m_drawn.points[m_first].position, .first = m_first, .count = 1});
  ++m_first;
}

bool FacePen::towards(double distance, glm::dvec2& at) const {
  for (int step = 0; step < 3; ++step) {
    const double off = distance - m_field.rim(at);
    if (std::abs(off) < 0.2 * m_field.cell())
      return true;
    at += off * m_field.inwards(at);
  }
  return std::abs(distance - m_field.rim(at)) < 0.75 * m_field.cell();
}

void FacePen::alongRim(const RimMark& mark, const MarkWidth& width) {
  glm::dvec2 middle = mark.near;
  if (std::abs(m_field.rim(mark.near) - mark.distance) > mark.reach ||
      m_field.rim(mark.near) <= 0.0 || !towards(mark.distance, middle))
    return;
  // Walks both ways in steps of about two cells.
  const int steps = std::max(1, int(std::lround(0.25 * mark.length / m_field.cell())));
  const double step = 0.5 * mark.length / double(steps);
  std::array<std::vector<glm::dvec2>, 2> halves;
  for (const int way : {0, 1}) {
    glm::dvec2 at = middle;
    glm::dvec2 heading(0.0);
    for (int i = 0; i < steps; ++i) {
      const glm::dvec2 in = m_field.inwards(at);
      glm::dvec2 along = way == 0 ? glm::dvec2(-in.y, in.x) : glm::dvec2(in.y, -in.x);
      if (in == glm::dvec2(0.0) || (i > 0 && glm::dot(along, heading) < 0.3))
        break;
      heading = along;
      at += step * along;
      if (!towards(mark.distance, at))
        break;
      halves[std::size_t(way)].push_back(at);
    }
  }
  std::vector<glm::dvec2> points(halves[0].rbegin(), halves[0].rend());
  points.push_back(middle);
  points.insert(points.end(), halves[1].begin(), halves[1].end());
  if (points.size() > 1)
    curve(points, width);
}

}  // namespace sline::render
