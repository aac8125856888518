// SPDX-License-Identifier: Apache-2.0
// A stack of contours → one closed surface.
#pragma once

#include "model/import/dicom/contour_stack.h"
#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Positions (mm, LPS), triangles, `smooth` and `displacement`; closed, manifold, outward. Slices
/// drawn by hand differ a little from each other; as `options.smoothing` asks, that is smoothed,
/// moving no vertex by more than three quarters of the slices' spacing. Empty where the contours
/// enclose nothing that the samples can show, or `goesOn` said no. `samples` is the most the stack
/// may have (samplesFor).
RawMesh surfaceOf(const ContourStack& stack, double samples, const ReadOptions& options);

}  // namespace sline::model
