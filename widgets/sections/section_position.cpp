// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_position.h"

#include <array>
#include <cmath>

#include "model/scene/known_frame.h"
#include "widgets/session/length_texts.h"

namespace sline::widgets {

model::Plane movedTo(model::Plane plane, double position) {
  const std::optional<int> axis = axisAcross(plane);
  const bool against = axis && plane.normal[*axis] < 0.0f;
  plane.offset = float(against ? -position : position);
  return plane;
}

QString positionText(const model::Plane& plane, const model::Scene& scene) {
  static constexpr std::array<const char*, 3> positive{"L", "P", "S"};
  static constexpr std::array<const char*, 3> negative{"R", "A", "I"};
  static constexpr std::array<const char*, 3> axes{"X", "Y", "Z"};
  const std::optional<int> axis = axisAcross(plane);
  const double position = positionOf(plane);
  const model::KnownSides sides = knownSides(scene);
  const double shown = axis && sides.any ? std::abs(position) : position;
  const QString length = lengthText(scene, shown == 0.0 ? 0.0 : shown, 1);
  if (!axis)
    return length;
  const auto& letters = !sides.any ? axes : position < 0.0 ? negative : positive;
  return QLatin1String(letters[std::size_t(*axis)]) +
         (sides.inDoubt(*axis) ? QStringLiteral("?") : QString()) + QChar(QChar::Nbsp) + length;
}

model::Plane flipped(const model::Plane& plane) {
  return {.normal = -plane.normal, .offset = -plane.offset};
}

}  // namespace sline::widgets
