// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/fitted_sides.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/lettering/column_widths.h"

namespace sline::render {

namespace {

model::FreeSides sidesOfShare(const glm::vec2& share) {
  const model::FreeSides air;
  const auto side = [&](float left) { return air.left + (0.5 - air.left) * (1.0 - double(left)); };
  const double x = side(share.x);
  const double y = side(share.y);
  return {.left = x, .right = x, .top = y, .bottom = y};
}

}  // namespace

glm::vec2 shareBesideMarks(const RoomOfMarks& marks, const glm::vec2& size) {
  // Fitted cameras leave 5 % on either side anyway.
  constexpr float airOfCameras = 1.06f;
  return glm::clamp(airOfCameras * (1.0f - marks.size / size), glm::vec2(leastAnatomyShare),
                    glm::vec2(1.0f));
}

model::FreeSides sidesBesideLabels(const model::Scene& scene, const model::Camera& camera,
                                   const glm::vec2& size, const LabelStyle& style,
                                   const RoomOfMarks& marks) {
  model::FreeSides sides = sidesOfShare(shareBesideMarks(marks, size));
  sides.right = std::max(sides.right, double(marks.legend / size.x));
  if (marks.foot > 0.0f)
    sides.bottom = std::min(sides.bottom + double(marks.foot / size.y),
                            1.0 - double(leastAnatomyShare) - sides.top);
  if (style.mode == LabelMode::off)
    return sides;
  // Wherever the camera is now, all that is visible is before it when it is fitted.
  const model::Camera there =
      model::fitted(camera, scene.visibleBounds().corners(), size.x / size.y);
  LabelStyle within = style;
  within.edges.top = 0.5f * marks.size.y;
  within.edges.bottom = within.edges.top + marks.foot;
  const ColumnWidths widths = widthsBesideFitted(scene, Screen(there, size), within);
  // Millimetres by which the anatomy's outline exceeds its points.
  constexpr float outline = 1.0f;
  const auto keep = [&](double& side, float column) {
    if (column > 0.0f)
      side = std::max(side, double((column + besideColumnMm() + outline) / size.x));
  };
  keep(sides.left, widths.left);
  keep(sides.right, widths.right);
  const double most = 1.0 - double(leastAnatomyShare);
  const double less = std::min(1.0, most / (sides.left + sides.right));
  sides.left *= less;
  sides.right *= less;
  return sides;
}

}  // namespace sline::render
