// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/streamline_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace sline::render {

namespace {

constexpr double thirdOfPi = 1.0471975511965976;
// Slower than this share of the corners' speed, a line has come to an umbilic.
constexpr double slowest = 1e-2;
// Where two triangles' fields push a line onto their common edge it would go to and fro.
constexpr int mostIdleCrossings = 6;
constexpr int mostTriangles = 4000;
constexpr int mostPieces = 64;  // in one triangle

double medianLength(const model::Surface& surface) {
  std::vector<double> lengths;
  lengths.reserve(surface.curvature.k.size());
  for (const auto& [position, normal, e1, k, derivative] : surface.vertices.all())
    if (const float largest = std::max(std::abs(k.x), std::abs(k.y)); largest > 0.0f)
      lengths.push_back(thirdOfPi / double(largest));
  if (lengths.empty())
    return 0.0;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

/// One line on its way.
class StreamlineTracer::Walk {
 public:
  Walk(const StreamlineTracer& tracer, double length, const Stops& stops)
      : m_tracer(tracer), m_stops(stops), m_left(length) {}

  std::vector<TracedPoint> from(const StreamlineStart& start, const glm::dvec3& direction) {
    m_triangle = start.triangle;
    m_at = start.at;
    m_direction = direction;
    m_frame = m_tracer.m_field.frame(m_triangle);
    keep();
    int idle = 0;
    for (int i = 0; i < mostTriangles && idle < mostIdleCrossings; ++i) {
      const double before = m_left;
      const std::optional<int> side = acrossTriangle();
      if (m_left < before)
        keep();
      if (!side || !enterNext(*side))
        break;
      idle = m_left < before ? 0 : idle + 1;
    }
    return std::move(m_points);
  }

 private:
  void keep() {
    const double way = m_points.empty() ? 0.0 : m_length;
    m_points.push_back({m_triangle, m_at, m_frame.place(m_at), way});
  }

  /// Goes on to a side of the triangle, which it returns, or to the end of the line.
  std::optional<int> acrossTriangle() {
    if (!(m_frame.inradius > 0.0))
      return std::nullopt;
    const LinearFlow flow = m_tracer.m_field.flow(m_triangle, m_frame, m_direction);
    for (int piece = 0; piece < mostPieces; ++piece) {
      const glm::dvec3 velocity = m_frame.along(flow.velocity(m_at));
      const double speed = glm::length(velocity);
      if (!(speed > slowest))
        return std::nullopt;
      m_direction = velocity / speed;
      const std::optional<TriangleExit> exit = exitWithin(flow, m_at, stepFrom(flow, speed));
      if (!goTo(flow, exit ? exit->at : m_next, exit ? exit->time : m_step))
        return std::nullopt;
      if (exit)
        return exit->side;
    }
    return std::nullopt;
  }

  /// Returns a time within which the line goes no farther than the triangle's inradius.
  double stepFrom(const LinearFlow& flow, double speed) {
    const auto farAt = [&](double step) {
      m_next = flow.at(m_at, step);
      return glm::length(m_frame.along(m_next - m_at)) > m_frame.inradius;
    };
    m_step = m_frame.inradius / speed;
    while (farAt(m_step))
      m_step *= 0.5;
    return m_step;
  }

  /// Returns false where the line is long enough before it gets there.
  bool goTo(const LinearFlow& flow, const glm::dvec2& at, double time) {
    const double piece = glm::length(m_frame.along(at - m_at));
    if (piece < m_left) {
      m_direction = glm::normalize(m_frame.along(flow.velocity(at)) + 1e-12 * m_direction);
      m_at = at;
      m_left -= piece;
      m_length += piece;
      return true;
    }
    m_at = flow.at(m_at, time * m_left / piece);
    m_length += m_left;
    m_left = 0.0;
    return false;
  }

  bool enterNext(int side) {
    const std::uint32_t next = m_tracer.m_neighbours.across(m_triangle, side);
    if (next == model::FaceNeighbours::none || (m_stops && m_stops(next, m_frame.place(m_at))))
      return false;
    const auto triangles = m_tracer.m_field.surface().mesh->triangles();
    const std::array<double, 3> here = barycentric(m_at);
    std::array<double, 3> there{};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (int(i) != side && triangles[m_triangle][i] == triangles[next][j]) {
          there[j] = std::max(here[i], 0.0);
          sum += there[j];
        }
    if (!(sum > 0.0))
      return false;
    m_triangle = next;
    m_at = {there[1] / sum, there[2] / sum};
    m_frame = m_tracer.m_field.frame(next);
    return true;
  }

  const StreamlineTracer& m_tracer;
  const Stops& m_stops;
  double m_left;  ///< mm
  double m_length = 0.0;
  std::uint32_t m_triangle = 0;
  glm::dvec2 m_at{0.0};
  glm::dvec3 m_direction{0.0};
  PrincipalField::Frame m_frame;
  glm::dvec2 m_next{0.0};
  double m_step = 0.0;
  std::vector<TracedPoint> m_points;
};

StreamlineTracer::StreamlineTracer(const PrincipalField& field,
                                   const model::FaceNeighbours& neighbours)
    : m_field(field), m_neighbours(neighbours), m_longest(medianLength(field.surface())) {}

double StreamlineTracer::length(std::uint32_t triangle) const {
  const double curvature = double(m_field.curvature(triangle));
  return curvature > 0.0 ? std::min(thirdOfPi / curvature, m_longest) : m_longest;
}

std::vector<TracedPoint> StreamlineTracer::trace(const StreamlineStart& start, bool along,
                                                 double length, const Stops& stops) const {
  const glm::dvec3 direction = m_field.direction(start.triangle);
  if (direction == glm::dvec3(0.0))
    return {};
  return Walk(*this, length, stops).from(start, along ? direction : -direction);
}

}  // namespace sline::render
