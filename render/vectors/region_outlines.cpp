// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/region_outlines.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

#include "render/vectors/bezier_fit.h"

namespace sline::render {

namespace {

/// Steps to the right, up, left and down.
constexpr std::array<glm::ivec2, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Walks along the edges between pixels with the region on the left.
class Tracer {
 public:
  Tracer(std::span<const std::uint8_t> inside, int width, int height)
      : m_inside(inside), m_width(width), m_height(height), m_walked(inside.size()) {}

  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < m_width && y < m_height &&
           m_inside[std::size_t(y) * std::size_t(m_width) + std::size_t(x)] != 0;
  }
  /// Tells whether an outline that was not walked yet runs to the right along the pixel's lower
  /// edge.
  bool startsAt(int x, int y) const {
    return at(x, y) && !at(x, y - 1) &&
           m_walked[std::size_t(y) * std::size_t(m_width) + std::size_t(x)] == 0;
  }

  /// Returns the corners of the outline; two regions that touch at a corner stay separate.
  std::vector<glm::ivec2> walk(int x, int y) {
    std::vector<glm::ivec2> corners;
    const glm::ivec2 start(x, y);
    glm::ivec2 corner = start;
    int heading = 0;
    do {
      if (heading == 0)
        m_walked[std::size_t(corner.y) * std::size_t(m_width) + std::size_t(corner.x)] = 1;
      corners.push_back(corner);
      corner += steps[std::size_t(heading)];
      heading = next(corner, heading);
    } while (corner != start || heading != 0);
    return corners;
  }

 private:
  int next(const glm::ivec2& corner, int heading) const {
    // Pixels ahead of the corner, to the left and to the right of the way.
    const glm::ivec2 d = steps[std::size_t(heading)];
    const glm::ivec2 n(-d.y, d.x);
    const auto pixel = [&](const glm::ivec2& side) {
      // The pixel that has its middle at corner + (d + side) / 2.
      const glm::ivec2 twice = 2 * corner + d + side - 1;
      return at(twice.x / 2, twice.y / 2);
    };
    if (!pixel(n))
      return (heading + 1) % 4;
    return pixel(-n) ? (heading + 3) % 4 : heading;
  }

  std::span<const std::uint8_t> m_inside;
  int m_width;
  int m_height;
  std::vector<std::uint8_t> m_walked;
};

double enclosed(const std::vector<glm::ivec2>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::ivec2& a = corners[i];
    const glm::ivec2& b = corners[(i + 1) % corners.size()];
    twice += double(a.x) * double(b.y) - double(b.x) * double(a.y);
  }
  return 0.5 * twice;
}

/// Returns the middles of the edges, each moved a little towards its neighbours, so that straight
/// but slanted edges become straight again.
std::vector<glm::vec2> smoothed(const std::vector<glm::ivec2>& corners, const PixelRect& area) {
  const std::size_t count = corners.size();
  std::vector<glm::vec2> middles(count);
  for (std::size_t i = 0; i < count; ++i)
    middles[i] = 0.5f * glm::vec2(corners[i] + corners[(i + 1) % count]);
  std::vector<glm::vec2> points(count);
  for (std::size_t i = 0; i < count; ++i)
    points[i] = glm::vec2(area.x, area.y) + 0.25f * middles[(i + count - 1) % count] +
                0.5f * middles[i] + 0.25f * middles[(i + 1) % count];
  return points;
}

}  // namespace

Path regionOutlines(std::span<const std::uint8_t> inside, const PixelRect& area, float smallest,
                    float tolerance) {
  Path path;
  Tracer tracer(inside, area.width, area.height);
  for (int y = 0; y < area.height; ++y)
    for (int x = 0; x < area.width; ++x) {
      if (!tracer.startsAt(x, y))
        continue;
      const std::vector<glm::ivec2> corners = tracer.walk(x, y);
      if (std::abs(enclosed(corners)) >= double(smallest))
        path.push_back(fittedLoop(smoothed(corners, area), tolerance));
    }
  return path;
}

}  // namespace sline::render
