// SPDX-License-Identifier: Apache-2.0
// Draws outlines where other structures hide them (METHOD §11.5), and keeps the lines behind a
// structure away from its outline (§11.6).
#pragma once

#include <vector>

#include "render/strokes/structure_lines.h"

namespace sline::render {

/// The share of their structure's pen that hidden outlines have.
inline constexpr float hiddenWidth = 0.6f;

/// Returns the dashes of the lines, which must be curved (line_curves.h): about 6 λ drawn, 4 λ not,
/// by the length of the curve in the picture. They are counted from where a line crosses heights
/// along the picture's vertical: these points stay while the scene turns about it, whichever lines
/// join or part, so that dashes do not crawl. Between two of them dashes are up to a fifth longer
/// or shorter.
std::vector<Segment> dashed(const std::vector<Segment>& segments, const PictureView& view);

/// Returns strokes for all outlines that the structure's own surface does not hide, as thin as
/// hidden ones are; where the outline itself is seen it covers them.
std::vector<Stroke> hiddenStrokes(const model::Surface& surface, const PictureView& view,
                                  const model::ResolvedStyle& style, const StructureLines& drawn,
                                  const PixelRect& area);

/// Returns how many pixels beyond the structure lines behind it stop; 0 where they do not.
float haloWidth(const model::Surface& surface, const PictureView& view,
                const model::ResolvedStyle& style);

/// Returns strokes that cover the outline and what lies beside it, where lines behind stop.
std::vector<Stroke> haloStrokes(const model::Surface& surface, const PictureView& view,
                                const model::ResolvedStyle& style, const StructureLines& drawn,
                                const PixelRect& area);

}  // namespace sline::render
