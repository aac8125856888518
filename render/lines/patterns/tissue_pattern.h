// SPDX-License-Identifier: Apache-2.0
// Draws the pattern of a tissue on a cut face, as printed atlases tell tissues apart. Marks are
// laid out in the plane's own millimetres, so they stay where they are while the camera turns and
// while the plane is moved along its normal.
#pragma once

#include <span>

#include "model/anatomy/cut_pattern.h"
#include "render/lines/hatching/hatching.h"
#include "render/lines/patterns/face_field.h"

namespace sline::render {

struct TissuePatternRequest {
  model::CutPattern pattern = model::CutPattern::plain;
  double spacing = 1.0;               ///< mm between neighbouring marks, about
  glm::vec3 fibres{0.0f};             ///< unit, patient frame: the direction of a muscle's fibres
  std::optional<PlaneWindow> window;  ///< what can be seen of the face; absent: all of it
  bool operator==(const TissuePatternRequest&) const = default;
};

/// λ between neighbouring marks at least, and at most `patternStep` times as much: spacings are
/// powers of that in mm, so that marks stay while the picture is zoomed a little.
inline constexpr double leastPatternSpacing = 3.4;
inline constexpr double patternStep = 1.4142135623730951;  // √2

/// Returns the spacing in mm in a picture where λ shows that many millimetres.
double patternSpacing(double millimetresPerUnit);

/// Returns the marks as strokes and dots within the face's rim that the other planes keep; none for
/// a face without triangles. On a face too large for its spacing they stand farther apart.
Hatching tissuePattern(const CutFace& face, std::span<const model::Plane> others,
                       TissuePatternRequest request);

}  // namespace sline::render
