// SPDX-License-Identifier: Apache-2.0
// Chooses lengths for scale bars.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

#include "model/camera/camera.h"
#include "model/scene/known_frame.h"
#include "model/scene/scene.h"

namespace sline::render {

/// Returns the largest of … 1, 2, 5, 10, 20 … that is no larger than `most`, which must be
/// positive.
double roundStep(double most);

/// A length that is drawn to scale.
struct ScaleLength {
  double millimetres = 0.0;
  double drawn = 0.0;  ///< in the unit of the picture's height
};
/// Returns the longest round length that is drawn within `most`, true at the depth of `at`, in a
/// picture of that height. It is absent where there is no scale: for a point behind the eye.
std::optional<ScaleLength> scaleLength(const model::Camera& camera, const glm::vec3& at,
                                       double height, double most);
/// Where a picture's scale bar is true.
struct ScalePlace {
  glm::vec3 at{0.0f};
  bool onCutFace = false;  ///< a face that the camera sees from its front; else mid-depth
};
/// Where the scale bars of a scene are true, in every product alike, so that a bar does not depend
/// on what the camera turns around: on the cut face that faces the camera, as that is what one
/// measures there, else in the middle of what is visible.
struct ScalePlaces {
  std::optional<glm::vec3> middle;   ///< absent where nothing is visible
  std::vector<model::Plane> planes;  ///< of the sections that cut what is visible
  /// Returns that of a camera; of several faces the one that it sees most from the front.
  std::optional<ScalePlace> in(const model::Camera& camera) const;
  bool operator==(const ScalePlaces&) const = default;
};
ScalePlaces scalePlaces(const model::Scene& scene);
/// Returns "5 mm", from 10 mm on "1 cm", from 1000 mm on "1 m", below 0.1 mm "50 µm", with the
/// number as the locale writes it; for a scene that is drawn in another unit its number of those:
/// "5 Å"; where the unit is doubted "1 cm?".
QString lengthText(double millimetres, const QLocale& locale,
                   model::DrawnUnit unit = model::DrawnUnit::millimetre);

}  // namespace sline::render
