// SPDX-License-Identifier: Apache-2.0
// Finds which part of each fill is seen, tone by tone, and how many tones are worth their outlines.
#pragma once

#include "render/vectors/layer_stack.h"

namespace sline::render {

struct FilledLayer {
  const DepthLayer& layer;
  std::size_t index = 0;  ///< in the stack
  /// One rank for each layer of the stack; layers of higher rank are painted later.
  std::span<const std::size_t> ranks;
};

/// Holds the part of a layer's fill that other fills do not hide.
struct SeenTones {
  PixelRect area;  ///< the smallest rectangle that holds it; empty where nothing is seen
  std::vector<std::uint8_t> tones;  ///< as in DepthLayer; 0 where nothing is seen
  std::vector<glm::vec4> colours;   ///< premultiplied
  std::size_t firstCapTone = 0;
  /// The share of its light that other fills leave on average, 0 … 1.
  float transmittance = 1.0f;
};

/// Returns the visible tones of a layer. `filled` is one of the stack's layers. Anything outside
/// the picture is left out.
SeenTones seenTones(const FilledLayer& filled, const LayerStack& stack);

/// Returns the total length of the outlines of all its tones, each around all that is at least as
/// light; pixels.
double outlineLength(const SeenTones& seen);

/// Joins every `count` neighbouring tones of the surface to one; cut faces keep theirs.
void joinTones(SeenTones& seen, std::size_t count);

/// Joins tones so that their outlines together are no longer than `mostOutline` pixels. It joins
/// most where a fill is hardly seen through others, as a step there is as faint as the fill.
void joinTonesWithin(std::span<SeenTones> all, double mostOutline);

}  // namespace sline::render
