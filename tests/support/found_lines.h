// SPDX-License-Identifier: Apache-2.0
// Compares the lines that techniques find on a `KnownSheet` with those that it has.
#pragma once

#include <optional>

#include "model/geometry/surface.h"
#include "render/lines/techniques/lines.h"
#include "tests/support/known_lines.h"

namespace sline::test {

/// A parallel view of the sheet, 25° from above.
model::Camera sheetCamera(const KnownSheet& sheet);
/// Returns what lines of that kind are on a sheet; nothing for kinds of which that is not known.
std::optional<KnownKind> knownKindOf(render::LineKind kind);

/// Returns how well the technique's lines at its usual thresholds agree with the sheet's, within
/// 1.5 of its cells, four cells and more from its edge. The surface is the sheet's mesh of so many
/// cells, or that roughened.
Agreement agreementOn(const KnownSheet& sheet, int cells, const model::Surface& surface,
                      render::LineKind kind);
/// The same of ConFIS, whose strokes run across what they tell: recall is the share of the known
/// ridges' and valleys' length with |H|·F_c above the threshold that a stroke comes near;
/// precision is the share of ink that lies on a wave, within 5σ, and runs within 15° across it, as
/// its stronger curvature does.
Agreement confisAgreementOn(const KnownSheet& sheet, int cells, const model::Surface& surface);

}  // namespace sline::test
