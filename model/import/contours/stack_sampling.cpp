// SPDX-License-Identifier: Apache-2.0
#include "model/import/contours/stack_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace sline::model {

namespace {

constexpr double mostSamples = 4e6;
/// Each point of a contour allows so many samples, so that a small file cannot ask for much work;
/// where there is only a handful of points each allows fewer, or thousands of specks would make
/// millions of triangles.
constexpr double samplesPerPoint = 1500.0;
constexpr double manyPoints = 100.0;
constexpr double fewestSamples = 500.0;
/// The size of a sample as a share of the structure's bounding sphere: the surface's triangles have
/// about the 2 % that hatching and curvature want (METHOD §5). Large bodies may have half of it, so
/// that no slice is left out.
constexpr double finest = 0.018;

/// Returns the area that the outlines of a slice enclose, measured along a few rows.
double areaOf(const SliceOutline& slice) {
  constexpr int rows = 48;
  double low = 1e300;
  double high = -1e300;
  for (const auto& [a, b] : slice.edges) {
    low = std::min({low, a.y, b.y});
    high = std::max({high, a.y, b.y});
  }
  if (!(high > low))
    return 0.0;
  const double step = (high - low) / rows;
  std::array<std::vector<double>, rows> crossings;
  for (auto [a, b] : slice.edges) {
    if (a.y > b.y)
      std::swap(a, b);
    const auto rowAbove = [&](double y) {
      return int(std::clamp(std::ceil((y - low) / step - 0.5), 0.0, double(rows)));
    };
    for (int row = rowAbove(a.y); row < rowAbove(b.y); ++row) {
      const double y = low + (row + 0.5) * step;
      crossings[std::size_t(row)].push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  double length = 0.0;
  for (std::vector<double>& row : crossings) {
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2)
      length += row[i + 1] - row[i];
  }
  return length * step;
}

/// Returns the number of layers; however coarse the samples are, flat stacks keep their ends and
/// their inside.
double layersFor(const ContourStack& stack, double height, double cell) {
  return std::max({std::ceil(height / cell) + 1.0, double(stack.slices.size()), 7.0});
}

double samplesAt(const StackExtent& extent, const ContourStack& stack, double height, double cell) {
  const glm::dvec2 size = (extent.high - extent.low) / cell + 6.0;
  return size.x * size.y * layersFor(stack, height, cell);
}

/// Returns the fewest samples, because each slice needs a few, however few there may be.
double fewestFor(const ContourStack& stack) {
  return fewestSamples + 64.0 * double(stack.slices.size());  // 36 each at the coarsest
}

struct SliceSpan {
  double low = 0.0;
  double height = 0.0;
};
SliceSpan spanOf(const ContourStack& stack) {
  const double low = stack.slices.front().offset - stack.spacing;
  return {low, stack.slices.back().offset + stack.spacing - low};
}

/// Returns the size of samples that shows the shape.
double cellFor(const ContourStack& stack, const StackExtent& extent) {
  const glm::dvec2 size = extent.high - extent.low;
  const double height = spanOf(stack).height;
  const double radius = 0.5 * std::sqrt(glm::dot(size, size) + height * height);
  double cell = std::max(std::min(finest * radius, stack.spacing), 0.5 * finest * radius);
  // The thickness of a rind is its area divided by half its outlines; it needs samples inside.
  cell = std::min({cell, 0.1 * size.x, 0.1 * size.y, 0.1 * height});
  if (extent.area > 0.0)
    cell = std::min(cell, 0.7 * extent.area / extent.length);
  return std::max({cell, 0.002 * radius, 0.01, 36.0 * extent.length / 6e7});
}

}  // namespace

StackExtent extentOf(const ContourStack& stack) {
  StackExtent extent;
  for (const SliceOutline& slice : stack.slices) {
    extent.points += double(slice.points);
    extent.area += areaOf(slice);
    for (const auto& [a, b] : slice.edges) {
      extent.low = glm::min(extent.low, glm::min(a, b));
      extent.high = glm::max(extent.high, glm::max(a, b));
      extent.length += glm::length(b - a);
    }
  }
  return extent;
}

StackSampling samplingOf(const ContourStack& stack, const StackExtent& extent, double samples) {
  const auto [low, height] = spanOf(stack);
  double cell = cellFor(stack, extent);
  while (samplesAt(extent, stack, height, cell) > std::max(samples, fewestFor(stack)))
    cell *= 1.05;
  StackSampling sampling;
  sampling.plane.cell = cell;
  const glm::dvec2 cells = glm::ceil((extent.high - extent.low) / cell);
  sampling.plane.columns = int(cells.x) + 5;
  sampling.plane.rows = int(cells.y) + 5;
  sampling.plane.origin =
      0.5 * (extent.low + extent.high) -
      0.5 * cell * glm::dvec2(sampling.plane.columns - 1, sampling.plane.rows - 1);
  sampling.layers = int(layersFor(stack, height, cell));
  sampling.low = low;
  sampling.step = height / double(sampling.layers - 1);
  return sampling;
}

double samplesFor(const ContourStack& stack) {
  const StackExtent extent = extentOf(stack);
  if (!(extent.length > 0.0))
    return 0.0;
  const double paid = samplesPerPoint * extent.points * std::min(1.0, extent.points / manyPoints);
  const double budget = std::min(mostSamples, fewestFor(stack) + paid);
  const double wanted = samplesAt(extent, stack, spanOf(stack).height, cellFor(stack, extent));
  return std::min(budget, wanted);
}

}  // namespace sline::model
