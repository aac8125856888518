// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/hatch_tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {
/// Returns acos(x) / (π/2) for x in 0 … 1, within 5·10⁻⁵ (M. Abramowitz, I. Stegun, "Handbook of
/// Mathematical Functions", 4.4.45); the library's function keeps the loop from being vectorised.
float quarterTurns(float x) {
  return 0.63661977f * std::sqrt(1.0f - x) *
         (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

// Cosines to the light: below the first all is shadow, above the second nothing.
constexpr float wholeShadow = -0.35f;
constexpr float noShadow = 0.3f;
constexpr float shadowWeight = 0.45f;
// The second, where hatching is as dark as a woodcut's; it begins where tones for print end.
constexpr float noShadowWhereDark = 0.95f;
constexpr float usualTone = 1.8f;
constexpr float woodcutTone = 2.4f;

/// Returns the cosine to the light from which on there is no shadow.
float endOfShadow(float tone) {
  const float dark = std::clamp((tone - usualTone) / (woodcutTone - usualTone), 0.0f, 1.0f);
  return noShadow + dark * (noShadowWhereDark - noShadow);
}

constexpr std::size_t pointsAtOnce = 128;

/// What is computed of some points in a row.
struct ToneBlock {
  std::array<float, pointsAtOnce> weight;
  std::array<float, pointsAtOnce> angle;
  std::array<float, pointsAtOnce> facing;
  bool dark = false;
};

/// Computes points of a stroke from that one on: k = S·w + (nv/d)·w, seen from the side that faces
/// the eye, where n, S and so k turn. All is written number by number, and without branches, so
/// that several points are computed at once.
template <bool atInfinity>
[[gnu::always_inline]] inline void computeTone(const LaidTile& tile, const LaidStroke& stroke,
                                               const HatchView& view, std::size_t from,
                                               ToneBlock& out) {
  const std::size_t row = stroke.rowLength();
  const std::size_t count = std::min(pointsAtOnce, row - from);
  const float* place = tile.positionRow(stroke, 0) + from;
  const std::int16_t* shape = tile.shapeRow(stroke, 0) + from;
  const glm::vec3 eye = view.eye.value;
  const glm::vec3 light = view.light;
  const float bare = view.bare;
  const float filigreeSize = view.filigreeSize;
  const float turned = view.twoSided ? -1.0f : 1.0f;
  const float shadowRange = endOfShadow(view.tone) - wholeShadow;
  const float normalStep = 1.0f / LaidTile::normalSteps;
  const float step = stroke.bendingStep;
  int dark = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float nx = normalStep * float(shape[i]);
    const float ny = normalStep * float(shape[row + i]);
    const float nz = normalStep * float(shape[2 * row + i]);
    const float toX = atInfinity ? eye.x : eye.x - place[i];
    const float toY = atInfinity ? eye.y : eye.y - place[row + i];
    const float toZ = atInfinity ? eye.z : eye.z - place[2 * row + i];
    const float squared = std::max(toX * toX + toY * toY + toZ * toZ, 1e-30f);
    const float perLength = 1.0f / std::sqrt(squared);
    const float vx = toX * perLength, vy = toY * perLength, vz = toZ * perLength;
    const float nv = nx * vx + ny * vy + nz * vz;
    const float wx = vx - nv * nx, wy = vy - nv * ny, wz = vz - nv * nz;
    const float bending =
        step * (wx * (float(shape[3 * row + i]) * wx +
                      2.0f * (float(shape[4 * row + i]) * wy + float(shape[5 * row + i]) * wz)) +
                wy * (float(shape[6 * row + i]) * wy + 2.0f * float(shape[7 * row + i]) * wz) +
                float(shape[8 * row + i]) * wz * wz);
    const float near = atInfinity ? 0.0f : nv * perLength;
    const float side = nv < 0.0f ? turned : 1.0f;
    const float facing = side * nv;
    const float towards = side * (nx * light.x + ny * light.y + nz * light.z);
    const float lit = std::min(std::max((towards - wholeShadow) / shadowRange, 0.0f), 1.0f);
    const float shadow = 1.0f - lit * lit * (3.0f - 2.0f * lit);
    const float hollow = -side * (bending + near * (wx * wx + wy * wy + wz * wz)) * filigreeSize;
    const float weight = std::max(hollow, shadowWeight * shadow);
    const float behind = 1.0f - facing;
    const float before = quarterTurns(std::min(facing, 1.0f));
    const float angle = facing > 0.0f ? before : behind;
    out.weight[i] = weight;
    out.angle[i] = angle;
    out.facing[i] = facing;
    dark |= int(angle < 1.0f) & int(angle * std::min(weight, 1.0f) > bare);
  }
  out.dark = dark != 0;
}

SLINE_WIDE_LOOPS
void toneFromAfar(const LaidTile& tile, const LaidStroke& stroke, const HatchView& view,
                  std::size_t from, ToneBlock& out) {
  computeTone<true>(tile, stroke, view, from, out);
}

SLINE_WIDE_LOOPS
void toneFromNear(const LaidTile& tile, const LaidStroke& stroke, const HatchView& view,
                  std::size_t from, ToneBlock& out) {
  computeTone<false>(tile, stroke, view, from, out);
}

constexpr std::size_t tableSize = 64;

std::array<float, tableSize + 2> widthTable() {
  std::array<float, tableSize + 2> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = 0.62f * std::pow(float(i) / float(tableSize), 1.2f);
  return table;
}
}  // namespace

float hatchWidth(float opacity) {
  static const std::array<float, tableSize + 2> table = widthTable();
  const float x = std::sqrt(std::clamp(opacity, 0.0f, 1.0f)) * float(tableSize);
  const std::size_t i = std::size_t(x);
  return table[i] + (x - float(i)) * (table[i + 1] - table[i]);
}

bool HatchTone::find(const LaidTile& tile, const LaidStroke& stroke, const HatchView& view) {
  for (std::vector<float>* row : {&weight, &angle, &facing})
    row->resize(stroke.rowLength());
  // Arrays of its own, of which the compiler knows that they are no input.
  ToneBlock block;
  bool dark = false;
  for (std::size_t i = 0; i < weight.size(); i += pointsAtOnce) {
    if (view.eye.atInfinity)
      toneFromAfar(tile, stroke, view, i, block);
    else
      toneFromNear(tile, stroke, view, i, block);
    dark = dark || block.dark;
    const std::size_t count = std::min(pointsAtOnce, weight.size() - i);
    std::copy_n(block.weight.begin(), count, weight.begin() + std::ptrdiff_t(i));
    std::copy_n(block.angle.begin(), count, angle.begin() + std::ptrdiff_t(i));
    std::copy_n(block.facing.begin(), count, facing.begin() + std::ptrdiff_t(i));
  }
  return dark;
}

}  // namespace sline::render
