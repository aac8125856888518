// SPDX-License-Identifier: Apache-2.0
#include "render/measures/warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

// Points of neighbouring pixels lie on one sheet where they are no farther apart than this many
// pixels' width; over a stretch of three pixels that holds down to 8° between surface and sight.
constexpr float sheetPixels = 20.0f;

/// Returns the line of sight through a pixel's centre, from the nearest to the farthest depth.
model::Ray sight(const glm::dmat4& toWorld, double x, double y) {
  const auto at = [&](double depth) {
    const glm::dvec4 p = toWorld * glm::dvec4(x, y, depth, 1.0);
    return glm::dvec3(p) / p.w;
  };
  const glm::dvec3 nearest = at(-1.0);
  return {.origin = glm::vec3(nearest), .direction = glm::vec3(at(1.0) - nearest)};
}

/// Tells whether the sixteen pixels that an interpolation at that place reads all show surface
/// close to the point.
bool onOneSheet(const SeenSurface& seen, const glm::vec2& place, const glm::vec3& point,
                float farthest) {
  const int left = int(std::floor(place.x - 0.5f)) - 1;
  const int first = int(std::floor(place.y - 0.5f)) - 1;
  if (left < 0 || first < 0 || left + 4 > seen.width || first + 4 > seen.height)
    return false;
  for (int y = first; y < first + 4; ++y)
    for (int x = left; x < left + 4; ++x) {
      const std::size_t i = seen.index(x, y);
      if (!seen.seen[i] || glm::distance(seen.points[i], point) > farthest)
        return false;
    }
  return true;
}

std::array<float, 4> cubicWeights(float t) {
  return {0.5f * t * (t * (2.0f - t) - 1.0f), 0.5f * (t * t * (3.0f * t - 5.0f) + 2.0f),
          0.5f * t * (t * (4.0f - 3.0f * t) + 1.0f), 0.5f * t * t * (t - 1.0f)};
}

}  // namespace

SeenSurface seenSurface(const model::Bvh& bvh, const PictureView& view) {
  SeenSurface seen{.width = int(view.size().x), .height = int(view.size().y)};
  const std::size_t count = std::size_t(seen.width) * std::size_t(seen.height);
  seen.points.resize(count);
  seen.seen.resize(count);
  const glm::dmat4 toWorld = glm::inverse(glm::dmat4(view.viewProjection()));
  parallelFor(std::size_t(seen.height), 4, [&](std::size_t row) {
    for (int x = 0; x < seen.width; ++x) {
      const model::Ray ray = sight(toWorld, 2.0 * (x + 0.5) / seen.width - 1.0,
                                   1.0 - 2.0 * (double(row) + 0.5) / seen.height);
      if (const auto hit = bvh.nearest(ray)) {
        const std::size_t i = seen.index(x, int(row));
        seen.points[i] = ray.origin + hit->t * ray.direction;
        seen.seen[i] = 1;
      }
    }
  });
  return seen;
}

std::vector<WarpedPixel> warp(const SeenSurface& now, const SeenSurface& before,
                              const PictureView& viewBefore) {
  std::vector<WarpedPixel> result;
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    if (!now.seen[i])
      continue;
    const glm::vec3& point = now.points[i];
    const PictureView::Point projected = viewBefore.project(point);
    if (projected.w <= 0.0f)
      continue;
    const glm::vec2 place{projected.pixel.x, viewBefore.size().y - projected.pixel.y};
    if (onOneSheet(before, place, point, sheetPixels * viewBefore.millimetresPerPixel(point)))
      result.push_back({.pixel = std::uint32_t(i), .from = place});
  }
  return result;
}

float sample(const PixelValues& values, const glm::vec2& place) {
  const glm::vec2 corner = glm::floor(place - 0.5f);
  const auto across = cubicWeights(place.x - 0.5f - corner.x);
  const auto down = cubicWeights(place.y - 0.5f - corner.y);
  float sum = 0.0f;
  for (int dy = 0; dy < 4; ++dy)
    for (int dx = 0; dx < 4; ++dx)
      sum += across[std::size_t(dx)] * down[std::size_t(dy)] *
             values.at(int(corner.x) - 1 + dx, int(corner.y) - 1 + dy);
  return std::clamp(sum, 0.0f, 1.0f);
}

}  // namespace sline::render
