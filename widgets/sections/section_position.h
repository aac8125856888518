// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

#include "model/scene/section.h"

namespace sline::widgets {

/// 0, 1 or 2 where the plane stands across the x, y or z axis of LPS; absent for an oblique one.
std::optional<int> axisAcross(const model::Plane& plane);

/// Where a plane stands, in millimetres: along its axis of LPS (positive towards the left, the back
/// and the head), an oblique one along its normal.
double positionOf(const model::Plane& plane);
/// The plane moved to that position.
model::Plane movedTo(model::Plane plane, double position);
/// "L 12.0 mm", "S 30.5 mm", for an oblique plane "12.0 mm", the number as the locale writes it.
QString positionText(const model::Plane& plane);
/// Keeps the other side.
model::Plane flipped(const model::Plane& plane);

}  // namespace sline::widgets
