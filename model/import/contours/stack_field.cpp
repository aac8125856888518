// SPDX-License-Identifier: Apache-2.0
#include "model/import/contours/stack_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "model/base/parallel.h"
#include "model/import/contours/slice_shape.h"
#include "model/import/contours/stack_sampling.h"

namespace sline::model {

namespace {

/// No value is nearer to 0 than this share of a sample, so that no triangle has an edge of zero
/// length.
constexpr float nearest = 0.02f;

/// Returns the slope at a knot between two chords: their weighted harmonic mean, none at extremes.
float slopeAt(float before, float after, float widthBefore, float widthAfter) {
  if (before * after <= 0.0f)
    return 0.0f;
  const float a = 2.0f * widthAfter + widthBefore;
  const float b = widthAfter + 2.0f * widthBefore;
  return (a + b) / (a / before + b / after);
}

/// Holds four knots of which the middle two enclose the interval; the outer ones may be absent.
struct Knots {
  const std::vector<float>* values[4] = {};
  float places[4] = {};

  float at(std::size_t i, float z) const {
    const float width = places[2] - places[1];
    const float f0 = (*values[1])[i];
    const float f1 = (*values[2])[i];
    const float chord = (f1 - f0) / width;
    float m0 = chord;
    float m1 = chord;
    if (values[0]) {
      const float w = places[1] - places[0];
      m0 = slopeAt((f0 - (*values[0])[i]) / w, chord, w, width);
    }
    if (values[3]) {
      const float w = places[3] - places[2];
      m1 = slopeAt(chord, ((*values[3])[i] - f1) / w, width, w);
    }
    const float t = (z - places[1]) / width;
    const float s = 1.0f - t;
    return (1.0f + 2.0f * t) * s * s * f0 + t * t * (3.0f - 2.0f * t) * f1 +
           width * t * s * (s * m0 - t * m1);
  }
};

/// Describes the end of those pieces of a slice that do not go on.
struct Cap {
  std::vector<float> distances;
  std::vector<std::uint32_t> piece;  ///< the nearest one, for each sample
  std::vector<float> rounding;       ///< per piece: from this depth on it is `height` high, mm
  float height = 0.0f;

  /// Returns the value at a sample; `way` is the distance from the slice.
  float at(std::size_t i, float way) const {
    const float depth = -distances[i];
    if (depth <= 0.0f)
      return std::max(-depth, way);
    const float rest = 1.0f - std::min(depth / rounding[piece[i]], 1.0f);
    return std::max(-depth, way - height * (1.0f - rest * rest));
  }
};

/// Returns which pieces of a slice overlap with some piece of another slice.
std::vector<char> overlapping(const SliceShape& shape, const SliceShape* other) {
  std::vector<char> chosen(shape.pieceCount() + 1, 0);
  if (other)
    for (std::size_t i = 0; i < shape.pieces().size(); ++i)
      if (other->pieces()[i] != 0)
        chosen[shape.pieces()[i]] = 1;
  chosen[0] = 0;
  return chosen;
}

bool any(const std::vector<char>& chosen) {
  return std::find(chosen.begin(), chosen.end(), char(1)) != chosen.end();
}

class StackField {
 public:
  StackField(const ContourStack& stack, const StackSampling& sampling)
      : m_stack(stack), m_sampling(sampling) {}

  FieldBox make(const std::function<bool()>& goesOn) {
    FieldBox box;
    const PlaneGrid& plane = m_sampling.plane;
    m_shapes.reserve(m_stack.slices.size());
    for (const SliceOutline& slice : m_stack.slices) {
      if (!goesOn())
        return box;
      m_shapes.emplace_back(slice, plane);
    }
    box.size = {plane.columns, plane.rows, m_sampling.layers};
    box.origin = {plane.origin.x, plane.origin.y, m_sampling.low};
    box.step = {plane.cell, plane.cell, m_sampling.step};
    box.values.assign(plane.size() * std::size_t(m_sampling.layers), float(plane.cell));
    const auto count = m_shapes.size();
    for (std::size_t gap = 0; gap <= count; ++gap) {
      if (!goesOn()) {
        box.values.clear();
        return box;
      }
      fillGap(box, gap);
    }
    closeBorder(box);
    return box;
  }

 private:
  const SliceShape* shape(std::ptrdiff_t i) const {
    return i >= 0 && i < std::ptrdiff_t(m_shapes.size()) ? &m_shapes[std::size_t(i)] : nullptr;
  }
  float placeOf(const SliceShape& s) const { return float(s.offset() - m_sampling.low); }

  /// Returns how far pieces shrank on their way from the slice `before`: the mean depth of their
  /// rims in it.
  std::vector<float> roundings(const SliceShape& ending, const SliceShape* before) const {
    const auto spacing = float(m_stack.spacing);
    const auto rim = float(0.75 * m_sampling.plane.cell);
    std::vector<double> sum(ending.pieceCount() + 1, 0.0);
    std::vector<double> weight(sum.size(), 0.0);
    for (std::size_t i = 0; before && i < ending.pieces().size(); ++i)
      if (ending.pieces()[i] != 0 && -ending.distances()[i] < rim) {
        sum[ending.pieces()[i]] += double(std::max(0.0f, -before->distances()[i]));
        weight[ending.pieces()[i]] += 1.0;
      }
    std::vector<float> result(sum.size(), 0.0f);
    for (std::size_t i = 0; i < ending.pieces().size(); ++i)
      result[ending.pieces()[i]] = std::max(result[ending.pieces()[i]], -ending.distances()[i]);
    // Edges are never sharp, but thin pieces keep their height.
    for (float& rounding : result)
      rounding = std::max(std::min(0.35f * spacing, 0.5f * rounding), 1e-3f);
    for (std::size_t i = 1; i < sum.size(); ++i)
      if (weight[i] > 0.0)
        result[i] = std::max(result[i], float(sum[i] / weight[i]));
    return result;
  }

  Cap capOf(const SliceShape& ending, const std::vector<char>& goesOn,
            const SliceShape* before) const {
    std::vector<char> ends(goesOn.size());
    for (std::size_t i = 1; i < ends.size(); ++i)
      ends[i] = goesOn[i] == 0;
    Cap cap;
    cap.distances = ending.distancesTo(ends, &cap.piece);
    cap.rounding = roundings(ending, before);
    cap.height = float(0.5 * m_stack.spacing);
    return cap;
  }

  /// Fills the layers between slice gap − 1 and slice gap.
  void fillGap(FieldBox& box, std::size_t gap) const {
    const auto index = std::ptrdiff_t(gap);
    const SliceShape* below = shape(index - 1);
    const SliceShape* above = shape(index);
    const double low = below ? below->offset() - m_sampling.low : -1.0;
    const double high = above ? above->offset() - m_sampling.low : 1e300;
    const auto first = int(std::ceil(std::max(low, 0.0) / m_sampling.step));
    const int last =
        std::min(m_sampling.layers - 1, int(std::ceil(std::min(high / m_sampling.step, 1e9))) - 1);
    if (first > last)
      return;
    std::optional<Cap> up;
    std::optional<Cap> down;
    Knots knots;
    std::vector<float> mainBelow;
    std::vector<float> mainAbove;
    if (below) {
      const std::vector<char> on = overlapping(*below, above);
      if (std::count(on.begin() + 1, on.end(), char(0)) > 0)
        up = capOf(*below, on, shape(index - 2));
      if (any(on)) {
        knots.values[1] = &(up ? mainBelow = below->distancesTo(on) : below->distances());
        knots.places[1] = placeOf(*below);
      }
    }
    if (above) {
      const std::vector<char> on = overlapping(*above, below);
      if (std::count(on.begin() + 1, on.end(), char(0)) > 0)
        down = capOf(*above, on, shape(index + 1));
      if (any(on)) {
        knots.values[2] = &(down ? mainAbove = above->distancesTo(on) : above->distances());
        knots.places[2] = placeOf(*above);
      }
    }
    addOuterKnots(knots, index);
    const std::size_t layer = m_sampling.plane.size();
    parallelFor(std::size_t(last) - std::size_t(first) + 1, 1, [&](std::size_t n) {
      const auto z = float(double(first + int(n)) * m_sampling.step);
      float* to = box.values.data() + (std::size_t(first) + n) * layer;
      for (std::size_t i = 0; i < layer; ++i) {
        float value = std::numeric_limits<float>::max();
        if (knots.values[1])
          value = knots.at(i, z);
        if (up)
          value = std::min(value, up->at(i, z - float(low)));
        if (down)
          value = std::min(value, down->at(i, float(high) - z));
        to[i] = value;
      }
    });
  }

  void addOuterKnots(Knots& knots, std::ptrdiff_t gap) const {
    if (const SliceShape* outer = shape(gap - 2)) {
      knots.values[0] = &outer->distances();
      knots.places[0] = placeOf(*outer);
    }
    if (const SliceShape* outer = shape(gap + 1)) {
      knots.values[3] = &outer->distances();
      knots.places[3] = placeOf(*outer);
    }
  }

  void closeBorder(FieldBox& box) const {
    const auto cell = float(m_sampling.plane.cell);
    const glm::ivec3 size = box.size;
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, ++i) {
          float& value = box.values[i];
          const bool border =
              x == 0 || y == 0 || z == 0 || x == size.x - 1 || y == size.y - 1 || z == size.z - 1;
          if (border)
            value = cell;
          value = std::clamp(value, -1e3f * cell, 1e3f * cell);
          if (std::abs(value) < nearest * cell)
            value = value < 0.0f ? -nearest * cell : nearest * cell;
        }
  }

  const ContourStack& m_stack;
  StackSampling m_sampling;
  std::vector<SliceShape> m_shapes;
};

}  // namespace

FieldBox fieldOf(const ContourStack& stack, double samples, const std::function<bool()>& goesOn) {
  const StackExtent extent = extentOf(stack);
  if (!(extent.length > 0.0))
    return {};
  return StackField(stack, samplingOf(stack, extent, samples)).make(goesOn);
}

}  // namespace sline::model
