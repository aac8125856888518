// SPDX-License-Identifier: Apache-2.0
// Turns the lines of one structure from its surface into the strokes that a pen draws (METHOD §4–5,
// §7).
#pragma once

#include <span>
#include <vector>

#include "model/scene/style.h"
#include "render/drawn/face_patterns.h"
#include "render/drawn/gamma_offsets.h"
#include "render/drawn/picture_view.h"
#include "render/drawn/prepared_surface.h"
#include "render/drawn/sectioned_surface.h"
#include "render/lines/hatching/hatching.h"
#include "render/lines/techniques/lines.h"
#include "render/raster/pixel_rect.h"
#include "render/strokes/stroke.h"

namespace sline::render {

/// Holds everything that a pen draws of one structure.
struct StructureLines {
  LineSet lines;
  Hatching hatching;
  std::vector<Segment> dashes;        ///< of the outlines, where the style wants hidden ones dashed
  std::vector<FacePattern> patterns;  ///< of cut faces
};

/// Tells whether a structure of that style shows any line.
bool showsLines(const model::ResolvedStyle& style);
bool showsHatching(const model::ResolvedStyle& style);
/// Returns the kinds of lines that the style's technique shows at its Γ.
LineKinds shownKinds(const model::ResolvedStyle& style);
/// Tells whether lines leave and the fill needs a soft edge of its own.
bool showsEdges(const model::ResolvedStyle& style);
/// Returns the share of width and opacity that Γ leaves to all lines alike; 1 where it varies.
float evenInk(const model::ResolvedStyle& style);
/// Returns the width of the pen in pixels for this structure, before Γ thins it (METHOD §4 ▲).
float penWidth(const model::Surface& surface, const PictureView& view, float penWeight);

/// Returns the segments that the style's lines and edges ask for, in the patient's frame. Where Γ
/// varies, each knows its own; without offsets it is the structure's. `light` is the direction
/// towards the light in the camera's frame, for lines that tell tone.
LineSet styledLines(PreparedSurface& prepared, const PictureView& view,
                    const model::ResolvedStyle& style, const GammaOffsets* offsets = nullptr,
                    const glm::vec3& light = model::upperLeftLight);
/// Returns the hatching that the structure's style asks for, lit as above; its surface is ready for
/// it.
Hatching styledHatching(const DrawnStructure& shown, const PictureView& view,
                        const glm::vec3& light);
/// Returns how many cells of hatching each of so many hatched structures may have in a picture, so
/// that however many there are it ends. Few structures are bounded each for itself, and a few more
/// or fewer change nothing.
std::size_t hatchCellsEach(std::size_t hatched);
/// Ends the lines at the section planes and adds the outlines of the cut faces.
void cutLines(const SectionedSurface& cut, StructureLines& drawn);
/// Finds when each line enters its stage and joins lines to the strokes that a pen would draw:
/// pieces of a line become one, specks fade, and lines that their own closed surface always hides
/// are removed. Each becomes the curve that a pen draws in light from there, a direction in the
/// camera's frame (line_curves.h).
void joinLines(const model::Surface& surface, const PictureView& view,
               const model::ResolvedStyle& style, const glm::vec3& light, StructureLines& drawn);

/// Holds how contours are tested in the picture; InkDraw has the same values.
struct ContourProbes {
  float probe = 3.0f;
  glm::vec2 reach{1.0f, 4.0f};
  float sheet = 0.0f;
};
ContourProbes contourProbes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style);

/// Returns the share of a pen's width that contours within their own mask have.
float innerContourShare(const model::ResolvedStyle& style);

/// Returns an outline with the share of its width and opacity that Γ at its ends leaves.
Segment leaving(const Segment& segment);

/// Returns the strokes within `area`: lines on the surface, then contours, each farthest first.
std::vector<Stroke> strokes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style, const StructureLines& drawn,
                            const PixelRect& area);

/// Returns the index where the contours begin among such strokes.
std::size_t firstContour(std::span<const Stroke> strokes);

/// Returns the contours within `area` as strokes of one pixel that soften a fill's edge, farthest
/// first; where Γ varies, as opaque as the fill is complete.
std::vector<Stroke> edges(const model::Surface& surface, const PictureView& view,
                          const model::ResolvedStyle& style, const LineSet& lines,
                          const PixelRect& area);

/// Returns the pixels that a stroke can touch.
PixelRect strokeBounds(const Stroke& segment);

}  // namespace sline::render
