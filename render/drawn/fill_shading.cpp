// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/fill_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/wide_loops.h"
#include "render/raster/rounding.h"
#include "render/sight/rules.h"

namespace sline::render {

namespace {

constexpr std::size_t rowPiece = 64;

/// What of a place's light decides how its fill looks.
struct Lit {
  float entered;    ///< the share of shading that has entered there
  float light;      ///< 0: the colour in shadow, 1: in full light
  float highlight;  ///< is added
};

/// What a fill's rules come to, in numbers: compilers work on one sample at a time where a loop
/// asks the same question at each.
struct FillNumbers {
  float onDark;     ///< 1: shading enters as light, 0: from the rim
  float turned;     ///< what turns away by more than this is seen from behind
  float least;      ///< see SurfaceFill::leastFacing
  glm::vec3 glaze;  ///< what a thin fill shows at least

  explicit FillNumbers(const SurfaceFill& fill)
      : onDark(fill.darkGround ? 1.0f : 0.0f),
        turned(fill.twoSided ? 0.0f : -most),
        least(fill.leastFacing),
        glaze(fill.darkGround ? glm::vec3(-most) : fill.colour) {}

 private:
  static constexpr float most = 1e30f;
};

/// Returns n·v of the side that is seen.
inline float facingAt(const FillNumbers& fill, float turned, float side) {
  return std::min(std::max(turned * side, fill.least), 1.0f);
}

/// Returns the share of shading that has entered.
inline float enteredAt(const FillNumbers& fill, float facing, float gradient, float shading,
                       float complete) {
  return rule::enteredAt(rule::enteringAngle(facing, fill.onDark), gradient, shading, complete);
}

/// The colours that one channel of a fill is mixed from.
struct ChannelColours {
  float shadow;
  float colour;
  float glaze;
  float wash;
};

/// Mixes one channel.
inline float channel(const ChannelColours& of, const Lit& lit, float opacity) {
  const float shade = rule::shaded(of.shadow, of.colour, lit.light, lit.highlight);
  return rule::layered(rule::glazed(shade, of.glaze, lit.entered), opacity, of.wash);
}

inline std::uint32_t byte(float value) {
  return nearestWhole(255.0f * std::min(value, 1.0f));
}

}  // namespace

glm::vec3 edgeColour(const glm::vec3& colour, const glm::vec3& key, const glm::vec2& outward) {
  constexpr float facing = 0.1f;
  const bool keyed = key != glm::vec3(0.0f);
  const float light =
      keyed ? rule::keyLight(facing, glm::dot(outward, glm::vec2(key)) + facing * key.z)
            : rule::headlight(facing);
  const glm::vec3 shadow = rule::inShadow(colour);
  const float glint = rule::highlight(keyed ? 0.0f : facing);
  glm::vec3 edge(0.0f);
  for (int c = 0; c < 3; ++c)
    edge[c] = rule::shaded(shadow[c], colour[c], light, glint);
  return edge;
}

FillShading::FillShading(const SurfaceFill& fill, const glm::vec3& key)
    : m_fill(fill), m_key(key), m_shadow(rule::inShadow(fill.colour)) {
  if (fill.gammaOffsets)
    m_stages = fillStages();
}

FillShading::Stages FillShading::stagesAt(float offset) const {
  const float gamma = std::clamp(m_fill.gamma + offset, 0.0f, 5.0f);
  const float at = rule::stagePlace(gamma);
  const std::size_t low = std::min<std::size_t>(std::size_t(at), m_stages.size() - 2);
  const glm::vec4 stage = glm::mix(m_stages[low], m_stages[low + 1], at - float(low));
  return {stage.x, stage.y};
}

glm::vec4 FillShading::colourAt(const glm::vec3& normal, const glm::vec3& towardsEye,
                                float gradient, float offset) const {
  const FillNumbers numbers(m_fill);
  const float turned = glm::dot(normal, towardsEye);
  const float side = turned < numbers.turned ? -1.0f : 1.0f;
  const float facing = facingAt(numbers, turned, side);
  const Stages stages =
      m_fill.gammaOffsets ? stagesAt(offset) : Stages{m_fill.shading, m_fill.complete};
  Lit lit{.entered = enteredAt(numbers, facing, gradient * side, stages.shading, stages.complete),
          .light = rule::headlight(facing),
          .highlight = rule::highlight(facing)};
  if (m_key != glm::vec3(0.0f)) {
    const glm::vec3 half = glm::normalize(m_key + towardsEye);
    lit.light = rule::keyLight(facing, side * glm::dot(normal, m_key));
    lit.highlight = rule::highlight(std::max(side * glm::dot(normal, half), 0.0f));
  }
  glm::vec4 colour(0.0f);
  const float opacity = lit.entered * m_fill.opacity;
  for (int c = 0; c < 3; ++c)
    colour[c] =
        channel({m_shadow[c], m_fill.colour[c], numbers.glaze[c], m_fill.wash[c]}, lit, opacity);
  colour.a = opacity + m_fill.wash.a * (1.0f - opacity);
  return colour;
}

template <bool keyed, bool varies, bool byForm>
[[gnu::always_inline]] inline void FillShading::shadeRow(const SampleRow& row,
                                                         std::uint32_t* colours) const {
  std::array<float, rowPiece> shading;
  std::array<float, rowPiece> complete;
  if (varies)
    for (std::size_t i = 0; i < row.count; ++i) {
      const Stages stages = stagesAt(row.gammaOffset[i]);
      shading[i] = stages.shading;
      complete[i] = stages.complete;
    }
  const FillNumbers numbers(m_fill);
  const auto coloursOf = [&](int c) {
    return ChannelColours{m_shadow[c], m_fill.colour[c], numbers.glaze[c], m_fill.wash[c]};
  };
  const ChannelColours reds = coloursOf(0), greens = coloursOf(1), blues = coloursOf(2);
  const float fillShading = m_fill.shading, fillComplete = m_fill.complete;
  const float fillOpacity = m_fill.opacity, washOpacity = m_fill.wash.a;
  const glm::vec3 key = m_key, towardsEye = row.towardsEye, step = row.step;
  const int first = row.column, count = int(row.count);
  const float *nx = row.normal[0], *ny = row.normal[1], *nz = row.normal[2];
  const float* gradient = row.gradient;
  SLINE_INDEPENDENT_ROUNDS
  for (int i = 0; i < count; ++i) {
    // From the same column wherever a row begins, so that pieces of a picture fit together.
    const auto column = float(first + i);
    const float vx = towardsEye.x + column * step.x;
    const float vy = towardsEye.y + column * step.y;
    const float vz = towardsEye.z + column * step.z;
    const float away = 1.0f / std::sqrt(vx * vx + vy * vy + vz * vz);
    const float unit =
        1.0f / std::sqrt(std::max(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i], 1e-20f));
    const float turned = (nx[i] * vx + ny[i] * vy + nz[i] * vz) * unit * away;
    const float side = turned < numbers.turned ? -1.0f : 1.0f;
    const float facing = facingAt(numbers, turned, side);
    Lit lit{.entered = enteredAt(numbers, facing, byForm ? gradient[i] * side : 0.0f,
                                 varies ? shading[std::size_t(i)] : fillShading,
                                 varies ? complete[std::size_t(i)] : fillComplete),
            .light = rule::headlight(facing),
            .highlight = rule::highlight(facing)};
    if (keyed) {
      const float hx = key.x + vx * away;
      const float hy = key.y + vy * away;
      const float hz = key.z + vz * away;
      const float half = 1.0f / std::sqrt(std::max(hx * hx + hy * hy + hz * hz, 1e-20f));
      lit.light =
          rule::keyLight(facing, side * unit * (nx[i] * key.x + ny[i] * key.y + nz[i] * key.z));
      lit.highlight = rule::highlight(
          std::max(side * unit * half * (nx[i] * hx + ny[i] * hy + nz[i] * hz), 0.0f));
    }
    const float opacity = lit.entered * fillOpacity;
    const std::uint32_t red = byte(channel(reds, lit, opacity));
    const std::uint32_t green = byte(channel(greens, lit, opacity));
    const std::uint32_t blue = byte(channel(blues, lit, opacity));
    const std::uint32_t alpha = byte(opacity + washOpacity * (1.0f - opacity));
    colours[i] = red | green << 8 | blue << 16 | alpha << 24;
  }
}

template <bool keyed>
[[gnu::always_inline]] inline void FillShading::shadeKeyed(const SampleRow& row,
                                                           std::uint32_t* colours) const {
  if (m_fill.gammaOffsets && m_fill.byForm)
    shadeRow<keyed, true, true>(row, colours);
  else if (m_fill.gammaOffsets)
    shadeRow<keyed, true, false>(row, colours);
  else if (m_fill.byForm)
    shadeRow<keyed, false, true>(row, colours);
  else
    shadeRow<keyed, false, false>(row, colours);
}

SLINE_WIDE_LOOPS void FillShading::shade(const SampleRow& row, std::uint32_t* colours) const {
  for (std::size_t first = 0; first < row.count; first += rowPiece) {
    SampleRow piece = row;
    for (const float*& normal : piece.normal)
      normal += first;
    piece.gradient = m_fill.byForm ? row.gradient + first : nullptr;
    piece.gammaOffset = m_fill.gammaOffsets ? row.gammaOffset + first : nullptr;
    piece.column += int(first);
    piece.count = std::min(row.count - first, rowPiece);
    if (m_key != glm::vec3(0.0f))
      shadeKeyed<true>(piece, colours + first);
    else
      shadeKeyed<false>(piece, colours + first);
  }
}

}  // namespace sline::render
