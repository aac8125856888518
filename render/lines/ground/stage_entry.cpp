// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/stage_entry.h"

#include <algorithm>
#include <cmath>

namespace sline::render {

namespace {
// The share of all ranks that are on their way in at the same time.
constexpr float softness = 0.5f;
// The share of every line's growth that does not wait for its rank: where all lines of some ranks
// are hidden or short the picture would stand still while the front passes over them.
constexpr float plainGrowth = 0.3f;

}  // namespace

// A front of width `softness` passes over the ranks 0 … 1. When it stands at u it has let in u²/2s,
// then u − s/2, then all but (1 + s − u)²/2s of them. The inverse says where it stands at T, so
// that the mean over the ranks is T; this also holds with any share of growing by T itself.
float entered(float t, float rank) {
  constexpr float s = softness;
  if (t <= 0.0f)
    return 0.0f;
  if (t >= 1.0f)
    return 1.0f;
  float front = t + 0.5f * s;
  if (t < 0.5f * s)
    front = std::sqrt(2.0f * s * t);
  else if (t > 1.0f - 0.5f * s)
    front = 1.0f + s - std::sqrt(2.0f * s * (1.0f - t));
  return plainGrowth * t + (1.0f - plainGrowth) * std::clamp((front - rank) / s, 0.0f, 1.0f);
}

}  // namespace sline::render
