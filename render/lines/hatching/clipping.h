// SPDX-License-Identifier: Apache-2.0
// Ends lines at section planes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/geometry/plane.h"
#include "render/lines/ground/segments.h"
#include "render/lines/hatching/hatching.h"

namespace sline::render {

/// Returns the part of the segment that all planes keep; nothing where no part is left. Ends that
/// are kept stay the same to the last bit, and so do those on a plane that neighbours share.
std::optional<Segment> clipped(const Segment& segment, std::span<const model::Plane> planes);
/// Clips each segment in place and drops those that are cut away completely; the order stays.
void clip(std::vector<Segment>& segments, std::span<const model::Plane> planes);
/// Cuts strokes into the parts that all planes keep, each as wide at the cut as it was there; their
/// seeds' names stay.
void clip(Hatching& hatching, std::span<const model::Plane> planes);

}  // namespace sline::render
