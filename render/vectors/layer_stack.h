// SPDX-License-Identifier: Apache-2.0
// Finds what lies in front of a point of the picture: the resolve pass (METHOD §10) on the CPU.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/vectors/depth_layer.h"

namespace sline::render {

/// Describes how much of something is left behind all that lies in front of it.
struct Veil {
  glm::vec3 colour{0.0f};      ///< of all that lies in front of it, premultiplied
  float transmittance = 1.0f;  ///< 1: nothing is in front of it … 0: it is hidden
};

/// One fill as it is seen at a pixel.
struct SeenFill {
  float depth = 1.0f;
  std::size_t layer = 0;
  glm::vec4 colour{0.0f};  ///< premultiplied
};

/// Returns what shows of nearer layers and of another behind them, premultiplied.
glm::vec4 laidBehind(const glm::vec4& nearer, const glm::vec4& colour);

class LayerStack {
 public:
  /// Stacks the layers, given in the order of their structures' ids, in a picture of that size.
  LayerStack(std::span<const DepthLayer> layers, glm::vec2 size);

  glm::vec2 size() const { return {float(m_width), float(m_height)}; }
  /// Returns what the fills of layers other than `own` leave of something at that depth.
  Veil before(const glm::vec2& pixel, float depth, std::size_t own) const;
  /// Tells whether a line of `own` at that depth stops beside a nearer structure.
  bool haloed(const glm::vec2& pixel, float depth, std::size_t own) const;
  /// Tells whether the outline of a nearer structure lies over a line of `own` at that depth.
  bool inked(const glm::vec2& pixel, float depth, std::size_t own) const;
  /// Returns the layer that is seen instead of something at that depth: the one with the nearest
  /// opaque fill in front of it.
  std::optional<std::size_t> hider(int x, int y, float depth, std::size_t own) const;

  /// Finds the fills that are seen at a pixel, nearest first, down to the first opaque one.
  void seenAt(int x, int y, std::vector<SeenFill>& fills) const;

  int width() const { return m_width; }
  int height() const { return m_height; }

 private:
  static constexpr int tileSide = 32;
  const std::vector<std::uint16_t>& listAt(int x, int y) const;
  /// At how many places around a pixel something lies before a line, or behind.
  struct Ring {
    int before = 0;
    int behind = 0;
  };
  /// Where a line of a layer is in the picture.
  struct LinePlace {
    glm::vec2 pixel{0.0f};
    float depth = 1.0f;
    std::size_t own = 0;  ///< its layer
  };
  /// Looks around a line for a layer that does not reach to it, but to within the radius. Where
  /// `surfaces`, and the line's own is there too, that layer is compared with it instead of with
  /// the line.
  Ring ringOf(std::size_t layer, const LinePlace& line, float radius, bool surfaces) const;

  /// The nearest depth in each block of a layer's pixels, so that most of them need not be looked
  /// at. Blocks count from the layer's corner.
  struct Blocks {
    int columns = 0;
    int rows = 0;
    std::vector<float> nearest;
  };
  static constexpr int blockSide = 16;
  static Blocks blocksOf(const DepthLayer& layer);
  /// Tells whether the layer may have something at that depth or nearer within the radius.
  bool mayBeNear(std::size_t layer, const glm::vec2& pixel, float depth, float radius) const;

  std::span<const DepthLayer> m_layers;
  std::vector<Blocks> m_blocks;  ///< of the layers that have a halo or ink
  int m_width = 0;
  int m_height = 0;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<std::size_t> m_haloed;                ///< the layers with a halo
  std::vector<std::vector<std::uint16_t>> m_tiles;  ///< the filled layers that touch each tile
};

}  // namespace sline::render
