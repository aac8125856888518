// SPDX-License-Identifier: Apache-2.0
// Writes lengths, areas and volumes of a scene as its pictures do: in the unit that they have, of
// molecules ångströms, and with a question mark where nobody knows it.
#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>

#include "model/lengths/told_length.h"
#include "model/scene/known_frame.h"
#include "model/scene/scene.h"

namespace sline::widgets {

/// Returns "12.3 mm", "45 µm?" or "6.0 Å" with so many places, without a number with one below 10
/// and none from there on.
QString lengthText(const model::Scene& scene, double millimetres,
                   std::optional<int> decimals = std::nullopt);
/// Returns the same of a length between surfaces that may be off: "≈ 12 mm".
QString lengthText(const model::Scene& scene, const model::DrawnLength& length);
/// Returns "140.0 × 60.0 × 60.0 mm".
QString sizeText(const model::Scene& scene, const glm::dvec3& millimetres);
/// Returns "88.20 cm²", for small surfaces "4.3 mm²" or "12 µm²", for those of molecules "820 Å²".
QString areaText(model::DrawnUnit unit, double squareMillimetres);
/// Returns "1.20 ml", and in the same way "4.3 mm³".
QString volumeText(model::DrawnUnit unit, double cubicMillimetres);
/// Returns what stands behind a number in millimetres of the patient's frame: " mm".
QString unitSuffix(const model::Scene& scene);

}  // namespace sline::widgets
