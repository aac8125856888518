// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/paper_tile.h"

#include <algorithm>
#include <cmath>

#include "render/sight/rules.h"
#include "render/strokes/ink.h"

namespace sline::render {

PaperTile paperTile(int percent, float pageHeightMm) {
  constexpr int pixels = 256;
  constexpr float pixelsPerGrain = 2.0f;
  constexpr float lambdas = 720.0f;  // of a page's height
  PaperTile tile{.image = {.width = pixels, .height = pixels, .rgba = {}},
                 .sideMm = float(pixels) / pixelsPerGrain * paperGrain * pageHeightMm / lambdas};
  tile.image.rgba.reserve(std::size_t(4) * pixels * pixels);
  const glm::vec2 grain(float(percent) / 100.0f, pixelsPerGrain);
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const float taken = rule::inkTaken({float(x) + 0.5f, float(y) + 0.5f}, grain);
      const auto grey = std::uint8_t(std::lround(255.0f * std::clamp(taken, 0.0f, 1.0f)));
      tile.image.rgba.insert(tile.image.rgba.end(), {grey, grey, grey, 255});
    }
  return tile;
}

int paperPercent(float grain) {
  return std::clamp(int(std::lround(100.0f * grain)), 0, 100);
}

}  // namespace sline::render
