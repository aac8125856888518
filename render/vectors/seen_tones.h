// SPDX-License-Identifier: Apache-2.0
// What of each fill is seen, tone by tone, and how many tones are worth their outlines.
#pragma once

#include "render/vectors/layer_stack.h"

namespace sline::render {

struct FilledLayer {
  const DepthLayer& layer;
  std::size_t index = 0;  ///< in the stack
  /// Of each layer of the stack: those of higher rank are painted later.
  std::span<const std::size_t> ranks;
};

/// The part of a layer's fill that other fills do not hide.
struct SeenTones {
  PixelRect area;  ///< the smallest rectangle that holds it; empty: nothing is seen
  std::vector<std::uint8_t> tones;  ///< as in DepthLayer; 0 where nothing is seen
  std::vector<glm::vec4> colours;   ///< premultiplied
  std::size_t firstCapTone = 0;
  /// What other fills leave of its light on the average, 0 … 1.
  float transmittance = 1.0f;
};

/// `filled` is one of the stack's layers. What lies beside the picture is left out.
SeenTones seenTones(const FilledLayer& filled, const LayerStack& stack);

/// How long the outlines of all its tones are, each around all that is at least as light; pixels.
double outlineLength(const SeenTones& seen);

/// Makes one tone of each so many neighbouring ones of the surface; cut faces keep theirs.
void joinTones(SeenTones& seen, std::size_t count);

/// Joins tones so that their outlines together are no longer than `mostOutline` pixels, most in
/// what is hardly seen through other fills: a step there is as faint as the fill.
void joinTonesWithin(std::span<SeenTones> all, double mostOutline);

}  // namespace sline::render
