// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/sampled_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
constexpr int blockSide = 8;
/// Reading a place uses samples up to two cells away along each axis.
constexpr float splineReach = 3.5f;
/// These are the variances, in squared spacings, of reading through the spline and of the weights 1
/// 2 1.
constexpr float splineVariance = 1.0f / 3.0f;
constexpr float passVariance = 0.5f;

/// Returns the distance from the middle of a cube of samples to its corner samples, mm.
float reachOf(int side, float spacing) {
  return 0.5f * std::sqrt(3.0f) * spacing * float(side - 1);
}

/// Returns the weights of the four samples around a place at t from 0 to 1 between the middle two.
std::array<float, 4> splineWeights(float t) {
  const float s = 1.0f - t;
  return {s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
          (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f};
}
}  // namespace

SampledField::SampledField(const LocalField& near, const Box& box, Fineness fineness)
    : m_box(box),
      m_spacing(fineness.spacing),
      m_band(splineReach * fineness.spacing + 1.5f * fineness.smoothing + fineness.depth) {
  const float spacing = fineness.spacing;
  m_size = glm::max(glm::ivec3(glm::ceil(box.size() / spacing)) + 1, glm::ivec3(4));
  m_values.resize(std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z));
  const glm::ivec3 blocks = (m_size + blockSide - 1) / blockSide;
  parallelFor(std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z), 4,
              [&](std::size_t block) {
                const int b = int(block);
                const glm::ivec3 first =
                    blockSide *
                    glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y);
                sampleBlock(near(middleOf(first, blockSide), reachOf(blockSide, spacing)), first,
                            blockSide);
              });
  const float wanted = fineness.smoothing * fineness.smoothing / (spacing * spacing);
  const int passes = int(std::lround((wanted - splineVariance) / passVariance));
  for (int pass = 0; pass < passes; ++pass)
    for (const int stride : {1, m_size.x, m_size.x * m_size.y})
      smoothOnce(stride);
}

void SampledField::smoothOnce(std::ptrdiff_t stride) {
  // At the ends of lines this reads samples of the neighbouring lines, but there the surface is far
  // away.
  const std::vector<float> old = m_values;
  const auto count = std::ptrdiff_t(old.size());
  parallelChunks(std::size_t(count - 2 * stride), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (auto i = std::ptrdiff_t(begin) + stride; i < std::ptrdiff_t(end) + stride; ++i)
      m_values[std::size_t(i)] =
          0.25f * (old[std::size_t(i - stride)] + old[std::size_t(i + stride)]) +
          0.5f * old[std::size_t(i)];
  });
}

glm::vec3 SampledField::middleOf(const glm::ivec3& first, int side) const {
  return m_box.low + m_spacing * (glm::vec3(first) + 0.5f * float(side - 1));
}

void SampledField::sampleBlock(const Field& field, const glm::ivec3& first, int side) {
  const glm::ivec3 end = glm::min(first + side, m_size);
  if (glm::any(glm::lessThanEqual(end, first)))
    return;
  const float middle = field(middleOf(first, side));
  const float reach = reachOf(side, m_spacing);
  // A sample need only be a lower bound if it influences no place on the surface through the
  // spline.
  const bool exact = std::abs(middle) < reach + m_band;
  if (exact && side > 1) {
    for (int part = 0; part < 8; ++part)
      sampleBlock(field, first + side / 2 * glm::ivec3(part & 1, part >> 1 & 1, part >> 2),
                  side / 2);
    return;
  }
  const float value = middle > 0.0f ? middle - reach : middle + reach;
  for (int z = first.z; z < end.z; ++z)
    for (int y = first.y; y < end.y; ++y)
      for (int x = first.x; x < end.x; ++x)
        m_values[(std::size_t(z) * std::size_t(m_size.y) + std::size_t(y)) * std::size_t(m_size.x) +
                 std::size_t(x)] = value;
}

float SampledField::distance(const glm::vec3& p) const {
  const glm::vec3 last = glm::vec3(m_size - 3) - 1e-3f;
  const glm::vec3 wanted = (p - m_box.low) / m_spacing;
  const glm::vec3 at = glm::clamp(wanted, glm::vec3(1.0f), last);
  const glm::ivec3 cell(at);
  const glm::vec3 t = at - glm::vec3(cell);
  const std::array<float, 4> wx = splineWeights(t.x);
  const std::array<float, 4> wy = splineWeights(t.y);
  const std::array<float, 4> wz = splineWeights(t.z);
  float sum = 0.0f;
  for (int k = 0; k < 4; ++k) {
    float plane = 0.0f;
    for (int j = 0; j < 4; ++j) {
      const float* row = &m_values[(std::size_t(cell.z + k - 1) * std::size_t(m_size.y) +
                                    std::size_t(cell.y + j - 1)) *
                                       std::size_t(m_size.x) +
                                   std::size_t(cell.x - 1)];
      plane +=
          wy[std::size_t(j)] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
    }
    sum += wz[std::size_t(k)] * plane;
  }
  return sum + m_spacing * glm::length(wanted - at);
}

}  // namespace sline::model
