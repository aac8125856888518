// SPDX-License-Identifier: Apache-2.0
// Lines end at section planes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/geometry/plane.h"
#include "render/lines/hatching.h"
#include "render/lines/lines.h"

namespace sline::render {

/// The part of the segment that all planes keep; nothing where none is left. Ends that are kept
/// stay the same to the last bit, and so do those on a plane that neighbours share.
std::optional<Segment> clipped(const Segment& segment, std::span<const model::Plane> planes);
/// Clips each segment in place and drops those of which nothing is left; the order stays.
void clip(std::vector<Segment>& segments, std::span<const model::Plane> planes);
/// Ends strokes at the planes. A stroke that comes back is one more stroke of the same seed.
void clip(Hatching& hatching, std::span<const model::Plane> planes);

}  // namespace sline::render
