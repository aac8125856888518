// SPDX-License-Identifier: Apache-2.0
// What lies before a point of the picture: the resolve pass (METHOD §10) on the CPU.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/vectors/depth_layer.h"

namespace sline::render {

/// What is left of something after all that lies before it.
struct Veil {
  glm::vec3 colour{0.0f};      ///< of all that lies before it, premultiplied
  float transmittance = 1.0f;  ///< 1 nothing is before it … 0 it is hidden
};

class LayerStack {
 public:
  /// Layers in the order of their structures' ids, within a picture of that size.
  LayerStack(std::span<const DepthLayer> layers, glm::vec2 size);

  /// What fills of other layers than `own` leave of something that deep.
  Veil before(const glm::vec2& pixel, float depth, std::size_t own) const;
  /// The layer that is seen instead of something that deep: with the nearest opaque fill before it.
  std::optional<std::size_t> hider(int x, int y, float depth, std::size_t own) const;

 private:
  static constexpr int tileSide = 32;
  const std::vector<std::uint16_t>& listAt(int x, int y) const;

  std::span<const DepthLayer> m_layers;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<std::vector<std::uint16_t>> m_tiles;  ///< filled layers that touch each
};

}  // namespace sline::render
