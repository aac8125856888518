// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/streamline_room.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace sline::render {

namespace {

float distanceToPiece(const glm::vec3& p, const TracedPoint& a, const TracedPoint& b) {
  const glm::vec3 from(a.place);
  const glm::vec3 along = glm::vec3(b.place) - from;
  const float length2 = glm::dot(along, along);
  const float t =
      length2 > 0.0f ? std::clamp(glm::dot(p - from, along) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, from + t * along);
}

/// Returns the distance from the place and finds the piece that lies nearest: that one or one
/// beside it, as steps are as small as triangles.
float distanceTo(std::span<const TracedPoint> line, const glm::vec3& place, std::uint32_t& piece) {
  const std::size_t low = piece > 0 ? piece - 1 : 0;
  const std::size_t high = std::min<std::size_t>(piece + 1, line.size() - 2);
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t i = low; i <= high; ++i)
    if (const float d = distanceToPiece(place, line[i], line[i + 1]); d < nearest) {
      nearest = d;
      piece = std::uint32_t(i);
    }
  return nearest;
}

// The most starts along a triangle's edge.
constexpr int mostStarts = 4;

/// Calls add(α, β) for the middles of the small triangles that n parts of each edge make.
template <class Add>
void forEachStart(int n, const Add& add) {
  const double part = 1.0 / (3.0 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add((3 * i + 1) * part, (3 * j + 1) * part);
      if (i + j + 1 < n)
        add((3 * i + 2) * part, (3 * j + 2) * part);
    }
}

}  // namespace

StreamlineRoom::StreamlineRoom(const model::Mesh& mesh, const model::FaceNeighbours& neighbours,
                               float fineness)
    : m_neighbours(neighbours), m_first{0} {
  const auto p = mesh.positions();
  const auto triangles = mesh.triangles();
  m_first.reserve(triangles.size() + 1);
  m_starts.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::vec3& origin = p[triangles[i][0]];
    const glm::vec3 u = p[triangles[i][1]] - origin;
    const glm::vec3 v = p[triangles[i][2]] - origin;
    const float longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
    const float parts = std::clamp(std::ceil(longest / fineness), 1.0f, float(mostStarts));
    forEachStart(int(parts), [&](double alpha, double beta) {
      m_starts.push_back({origin + float(alpha) * u + float(beta) * v, std::uint32_t(i),
                          std::numeric_limits<float>::infinity()});
    });
    m_first.push_back(std::uint32_t(m_starts.size()));
  }
}

StreamlineStart StreamlineRoom::start(std::size_t i) const {
  const std::uint32_t triangle = m_starts[i].triangle;
  const std::uint32_t count = m_first[triangle + 1] - m_first[triangle];
  const int parts = int(std::lround(std::sqrt(double(count))));
  StreamlineStart found{triangle};
  std::uint32_t next = m_first[triangle];
  forEachStart(parts, [&](double alpha, double beta) {
    if (next++ == i)
      found.at = {alpha, beta};
  });
  return found;
}

std::span<StreamlineRoom::Start> StreamlineRoom::startsIn(std::uint32_t triangle) {
  return std::span(m_starts).subspan(m_first[triangle], m_first[triangle + 1] - m_first[triangle]);
}

float StreamlineRoom::near(std::uint32_t triangle, const glm::vec3& place) const {
  std::uint32_t nearest = m_first[triangle];
  for (std::uint32_t i = nearest + 1; i < m_first[triangle + 1]; ++i)
    if (glm::distance(place, m_starts[i].place) < glm::distance(place, m_starts[nearest].place))
      nearest = i;
  return m_starts[nearest].room;
}

template <class Take>
void StreamlineRoom::spread(std::span<const TracedPoint> line, const Take& take) {
  m_steps.clear();
  const auto reach = [&](Step step) {
    if (take(step))
      m_steps.push_back(step);
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    reach({line[i].triangle, std::uint32_t(i)});
    reach({line[i + 1].triangle, std::uint32_t(i)});
  }
  // Steps are added on the way.
  std::size_t next = 0;
  while (next < m_steps.size()) {
    const Step step = m_steps[next++];
    for (int side = 0; side < 3; ++side)
      if (const std::uint32_t beside = m_neighbours.across(step.triangle, side);
          beside != model::FaceNeighbours::none)
        reach({beside, step.piece});
  }
}

void StreamlineRoom::add(std::span<const TracedPoint> line, float reach) {
  spread(line, [&](Step& step) {
    bool nearer = false;
    for (Start& start : startsIn(step.triangle)) {
      const float distance = distanceTo(line, start.place, step.piece);
      if (distance >= std::min(start.room, reach))
        continue;
      start.room = distance;
      nearer = true;
    }
    return nearer;
  });
}

void StreamlineRoom::refuse(std::span<const TracedPoint> line, float reach, float room) {
  spread(line, [&](Step& step) {
    bool limited = false;
    for (Start& start : startsIn(step.triangle)) {
      if (start.room <= room || distanceTo(line, start.place, step.piece) >= reach)
        continue;
      start.room = room;
      limited = true;
    }
    return limited;
  });
}

}  // namespace sline::render
