// SPDX-License-Identifier: Apache-2.0
// Paints on structures: Γ follows what is painted (METHOD §7).
#pragma once

#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

/// Returns the curve by which Γ first follows what is painted on a structure of that Γ, so that it
/// is seen: what is painted is shaded, and where the structure is more than lines already, all else
/// is lowered.
std::vector<GammaPoint> firstPaintedCurve(Gamma own);

/// Gives the structure that paint; null, or a value of 0 everywhere, is none. Γ follows it from
/// then on, by the first curve where it did not before. A locked structure stays as it is.
Edited withPaint(const Scene& scene, NodeId structure, PaintPtr paint);

}  // namespace sline::model
