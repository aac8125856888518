// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "model/scene/scene.h"
#include "model/scene/section.h"

namespace sline::widgets {

/// Returns the plane moved to that position.
model::Plane movedTo(model::Plane plane, double position);
/// Returns "L 12.0 mm", "S 30.5 mm", or for an oblique plane "12.0 mm", with the number as the
/// locale writes it; "L? 12.0 mm" where the sides of what the scene shows are not sure, and
/// "X -12.0 Å" where it has none.
QString positionText(const model::Plane& plane, const model::Scene& scene);
/// Returns the plane that keeps the other side.
model::Plane flipped(const model::Plane& plane);

}  // namespace sline::widgets
