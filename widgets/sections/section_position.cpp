// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_position.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>
#include <cmath>

namespace sline::widgets {

model::Plane movedTo(model::Plane plane, double position) {
  const std::optional<int> axis = axisAcross(plane);
  const bool against = axis && plane.normal[*axis] < 0.0f;
  plane.offset = float(against ? -position : position);
  return plane;
}

QString positionText(const model::Plane& plane) {
  static constexpr std::array<const char*, 3> positive{"L", "P", "S"};
  static constexpr std::array<const char*, 3> negative{"R", "A", "I"};
  const std::optional<int> axis = axisAcross(plane);
  const double position = positionOf(plane);
  const double shown = axis ? std::abs(position) : position;
  const QString length = QCoreApplication::translate("sline::widgets", "%1 mm")
                             .arg(QLocale().toString(shown == 0.0 ? 0.0 : shown, 'f', 1));
  if (!axis)
    return length;
  const auto& letters = position < 0.0 ? negative : positive;
  return QLatin1String(letters[std::size_t(*axis)]) + QChar(QChar::Nbsp) + length;
}

model::Plane flipped(const model::Plane& plane) {
  return {.normal = -plane.normal, .offset = -plane.offset};
}

}  // namespace sline::widgets
