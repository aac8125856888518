// SPDX-License-Identifier: Apache-2.0
// Finds which segments and points the eye can see, by rays against the line's own surface: exact
// where the picture's depth test is as fine as its pixels.
#pragma once

#include <vector>

#include "model/geometry/bvh.h"
#include "render/lines/hatching/hatching.h"
#include "render/lines/patterns/cut_faces.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// Returns one entry per segment: true where the middle of the segment can be seen. The part of the
/// surface that the planes of `faces` take away hides nothing; the faces themselves do.
std::vector<bool> visibleSegments(const model::Surface& surface, const model::Bvh& bvh,
                                  const model::Camera& camera, const std::vector<Segment>& segments,
                                  std::span<const CutFace> faces = {});

/// Returns one entry per point of the strokes, tested as `visibleSegments` tests middles.
std::vector<bool> visiblePoints(const model::Surface& surface, const model::Bvh& bvh,
                                const model::Camera& camera, const Hatching& hatching,
                                std::span<const CutFace> faces = {});

/// Returns one entry per contour segment: true where it borders the surface's own mask, that is
/// where the line of sight that passes just outside it meets nothing (Γ = 0, S §3.2).
std::vector<bool> silhouetteSegments(const model::Surface& surface, const model::Bvh& bvh,
                                     const model::Camera& camera,
                                     const std::vector<Segment>& contours,
                                     std::span<const CutFace> faces = {});

}  // namespace sline::render
