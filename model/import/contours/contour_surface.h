// SPDX-License-Identifier: Apache-2.0
// Turns a stack of contours into one closed surface.
#pragma once

#include "model/import/contours/contour_stack.h"
#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Returns positions (mm, LPS), triangles, `smooth` and `displacement` of a closed, manifold
/// surface that is oriented outward. Slices drawn by hand differ a little from each other; as
/// `options.smoothing` asks, these differences are smoothed, moving no vertex by more than three
/// quarters of the slices' spacing. The surface is empty where the contours enclose nothing that
/// the samples can show, or `goesOn` said no. `samples` is the most samples the stack may have
/// (samplesFor).
RawMesh surfaceOf(const ContourStack& stack, double samples, const ReadOptions& options);

}  // namespace sline::model
