// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "model/scene/section.h"

namespace sline::widgets {

/// Returns the plane moved to that position.
model::Plane movedTo(model::Plane plane, double position);
/// Returns "L 12.0 mm", "S 30.5 mm", or for an oblique plane "12.0 mm", with the number as the
/// locale writes it.
QString positionText(const model::Plane& plane);
/// Returns the plane that keeps the other side.
model::Plane flipped(const model::Plane& plane);

}  // namespace sline::widgets
