// SPDX-License-Identifier: Apache-2.0
// Blends a row of a square's pixels layer by layer, several pixels at once, where the layers lie in
// one order all along it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/raster/tile_mask.h"
#include "render/sight/rules.h"

namespace sline::render {

/// What a layer has in the row.
struct LayerRow {
  std::size_t first = 0;  ///< pixel of the row
  std::size_t count = 0;
  const float* depths = nullptr;           ///< 1: nothing is there
  const std::uint32_t* colours = nullptr;  ///< null: it has no fill
  const std::uint16_t* inks = nullptr;     ///< null: it has no ink
  glm::vec3 ink{0.0f};                     ///< 0 … 255
  bool haloed = false;
};

class BlendRow {
 public:
  /// More than this hides all that lies behind; of 255.
  static constexpr float opaque = 255.0f * rule::hidesAll;
  /// A layer whose stored value, of 255, is more keeps lines behind it away.
  static constexpr int haloAbove = int(255.0f * rule::haloAbove);

  /// Begins anew.
  void start();
  /// Lays a layer behind those that were laid before. Returns false where it lies, at some pixel,
  /// no deeper than what is seen of them: then the row has to be blended otherwise.
  bool lay(const LayerRow& row);
  /// Lays the ground, premultiplied and 0 … 255, behind all of it and returns the colours.
  void finish(const glm::vec4& ground, std::size_t count, std::uint32_t* out) const;

 private:
  static constexpr auto size = std::size_t(TileMask::side);
  using Values = std::array<float, size>;

  alignas(64) std::array<Values, 4> m_sums{};  ///< of the layers' channels
  alignas(
      64) Values m_lines{};  ///< the share of lines that is left behind the halos of nearer ones
  alignas(64) Values m_depths{};  ///< of the last layer at each pixel
};

}  // namespace sline::render
