// SPDX-License-Identifier: Apache-2.0
// Lengths for scale bars.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

#include "model/scene/camera.h"

namespace sline::render {

/// The largest of … 1, 2, 5, 10, 20 … that is no larger than `most`, which is positive.
double roundStep(double most);

/// A length that is drawn to scale.
struct ScaleLength {
  double millimetres = 0.0;
  double drawn = 0.0;  ///< in the unit of the picture's height
};
/// The longest of round length within `most`, true at the depth of `at`, in a picture of that
/// height. Absent where there is no scale: for a point behind the eye.
std::optional<ScaleLength> scaleLength(const model::Camera& camera, const glm::vec3& at,
                                       double height, double most);
/// "5 mm", from 10 mm on "1 cm", from 1000 mm on "1 m", the number as the locale writes it.
QString lengthText(double millimetres, const QLocale& locale);

}  // namespace sline::render
