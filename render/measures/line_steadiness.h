// SPDX-License-Identifier: Apache-2.0
// Measures whether lines hold still while the scene turns (METHOD §11.3, §11.5).
//
// A point of a stroke **pops** from one picture to another where the other has no ink of its
// structure with at least half of its weight (width · opacity) within 4 λ of where the point then
// lies, though what is lost is at least 0.4 λ, a fifth of the pen, and so can be seen. A point that
// a surface clearly covers in the other picture has gone behind that surface's edge: the edge came
// nearer step by step, so the point does not pop; nor does one that has left the page. Clearly
// means by 2 λ in depth, so that lines that flicker because their own surface lies a hair in front
// of them do count. A stretch of points that pop counts if it is longer than 4 mm on a sheet 180 mm
// high: 16 λ. Both ways are counted: what vanishes and what appears.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "render/measures/ink_frames.h"

namespace sline::render {

inline constexpr float popReach = 4.0f;        ///< λ
inline constexpr float popLoss = 0.4f;         ///< λ of width · opacity
inline constexpr float popCoverDepth = 2.0f;   ///< λ
inline constexpr float popStretch = 16.0f;     ///< λ
inline constexpr float flickerStretch = 4.0f;  ///< λ, of what is only reported
/// At most this share of the length may pop at a step.
inline constexpr double popLimit = 0.005;
/// The share of dashes that another phase would leave without ink is 0.4; of steady ones it is at
/// most this at a step.
inline constexpr double crawlLimit = 0.05;

/// Adds up what happens from one picture to the next, in λ.
struct LinePops {
  double drawn = 0.0;      ///< length of lines that can be seen, mean of both pictures
  double popped = 0.0;     ///< length that vanishes or appears
  double longest = 0.0;    ///< of the stretches that pop
  double flickered = 0.0;  ///< length in stretches from 4 λ on, those that pop among them
  /// Length that flickers by structure, and then by kind.
  std::map<std::string, std::array<double, lineKindCount>> where;
  double dashes = 0.0;   ///< length of dashes, both pictures
  double crawled = 0.0;  ///< of it, what lies in a gap of the other picture

  double flicker() const { return drawn > 0.0 ? flickered / drawn : 0.0; }
  double share() const { return drawn > 0.0 ? popped / drawn : 0.0; }
  double crawl() const { return dashes > 0.0 ? crawled / dashes : 0.0; }
};

/// Compares two pictures of the same scene.
LinePops popsBetween(const InkFrame& before, const InkFrame& now);

}  // namespace sline::render
