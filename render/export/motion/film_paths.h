// SPDX-License-Identifier: Apache-2.0
// Makes what changes from frame to frame steady.
#pragma once

#include <optional>
#include <vector>

#include "render/export/motion/film.h"

namespace sline::render {

/// Tells of each frame whether something is there.
using Presence = std::vector<bool>;

/// Returns the mean of each value and its neighbours, as many frames to either side; in a film that
/// loops, its end and its beginning are neighbours.
std::vector<float> averaged(const std::vector<float>& values, std::size_t radius, bool loops);

/// Returns a path that stays within `slack` of the places, apart from smoothing, moves as little as
/// that allows and never fast: at most 25 mm a second. Between frames with a place it goes evenly.
std::vector<float> steadyPath(const std::vector<std::optional<float>>& places, float slack,
                              const Film& film);

/// Returns 1 where it is there, and less within so many frames before and after, down to 0.
std::vector<float> eased(const Presence& there, std::size_t frames, bool loops);

}  // namespace sline::render
