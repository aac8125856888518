// SPDX-License-Identifier: Apache-2.0
// Joins the picture's strokes to the lines that a pen would draw in one go.
#pragma once

#include <span>
#include <vector>

#include "render/strokes/stroke.h"

namespace sline::render {

/// Segments one after the other, each turned so that its b is the next one's a.
using InkChain = std::vector<Stroke>;

/// Returns chains that hold every segment once. Neighbours share their ends to the last bit, in the
/// picture and in depth; a chain ends where a line ends, or where more than two segments meet.
std::vector<InkChain> inkChains(std::span<const Stroke> segments);

}  // namespace sline::render
