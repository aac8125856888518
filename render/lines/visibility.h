// SPDX-License-Identifier: Apache-2.0
// Which segments and points the eye can see, by rays against the line's own surface: exact where
// the picture's depth test is as fine as its pixels.
#pragma once

#include <vector>

#include "model/geometry/bvh.h"
#include "render/lines/cut_faces.h"
#include "render/lines/hatching.h"
#include "render/lines/lines.h"

namespace sline::render {

/// One entry per segment: true where the middle of the segment can be seen. What the planes of
/// `faces` take away hides nothing; the faces themselves do.
std::vector<bool> visibleSegments(const model::Surface& surface, const model::Bvh& bvh,
                                  const model::Camera& camera, const std::vector<Segment>& segments,
                                  std::span<const CutFace> faces = {});

/// One entry per point of the strokes; the same as above for each.
std::vector<bool> visiblePoints(const model::Surface& surface, const model::Bvh& bvh,
                                const model::Camera& camera, const Hatching& hatching,
                                std::span<const CutFace> faces = {});

/// One entry per contour segment: true where it borders the surface's own mask, that is where the
/// line of sight that passes just outside of it meets nothing (Γ = 0, S §3.2).
std::vector<bool> silhouetteSegments(const model::Surface& surface, const model::Bvh& bvh,
                                     const model::Camera& camera,
                                     const std::vector<Segment>& contours,
                                     std::span<const CutFace> faces = {});

}  // namespace sline::render
