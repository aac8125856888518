// SPDX-License-Identifier: Apache-2.0
// Lines of one structure, from its surface to the strokes that a pen sets (METHOD §4–5, §7).
#pragma once

#include <span>
#include <vector>

#include "model/scene/style.h"
#include "render/lines/hatching.h"
#include "render/lines/lines.h"
#include "render/raster/pixel_rect.h"
#include "render/strokes/picture_view.h"
#include "render/strokes/sectioned_surface.h"
#include "render/strokes/stroke.h"

namespace sline::render {

/// All that a pen draws of one structure.
struct StructureLines {
  LineSet lines;
  Hatching hatching;
};

/// True where a structure of that style shows any line.
bool showsLines(const model::ResolvedStyle& style);
bool showsHatching(const model::ResolvedStyle& style);
/// True where lines leave and the fill needs a soft edge of its own.
bool showsEdges(const model::ResolvedStyle& style);
/// Width of the pen in pixels for this structure, before Γ thins it (METHOD §4 ▲).
float penWidth(const model::Surface& surface, const PictureView& view, float penWeight);

/// The segments that the style's lines and edges ask for, in the patient's frame.
LineSet styledLines(const model::Surface& surface, const PictureView& view,
                    const model::ResolvedStyle& style);
/// The hatching that the style asks for, with the light there in the camera's frame.
Hatching styledHatching(StrokeLayout& layout, const PictureView& view,
                        const model::ResolvedStyle& style, const glm::vec3& light);
/// Ends them at the section planes and adds the outlines of the cut faces.
void cutLines(const SectionedSurface& cut, StructureLines& drawn);
/// Finds when each enters its stage and joins them to the strokes a pen would set: pieces of a line
/// become one, specks fade, and what its own closed surface always hides goes.
void joinLines(const model::Surface& surface, const PictureView& view,
               const model::ResolvedStyle& style, LineSet& lines);

/// How contours are looked at in the picture; see InkDraw, which has the same.
struct ContourProbes {
  float probe = 3.0f;
  glm::vec2 reach{1.0f, 4.0f};
  float sheet = 0.0f;
};
ContourProbes contourProbes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style);

/// The strokes within `area`: lines on the surface, then contours, each farthest first.
std::vector<Stroke> strokes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style, const StructureLines& drawn,
                            const PixelRect& area);

/// Where the contours begin among such strokes.
std::size_t firstContour(std::span<const Stroke> strokes);

/// The contours within `area` as strokes of one pixel that soften a fill's edge, farthest first.
std::vector<Stroke> edges(const model::Surface& surface, const PictureView& view,
                          const LineSet& lines, const PixelRect& area);

/// Pixels that a stroke can touch.
PixelRect strokeBounds(const Stroke& segment);

}  // namespace sline::render
