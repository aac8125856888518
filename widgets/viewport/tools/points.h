// SPDX-License-Identifier: Apache-2.0
// Converts points between Qt and GLM, unchanged.
#pragma once

#include <QPointF>
#include <glm/vec2.hpp>

namespace sline::widgets {

inline QPointF point(const glm::vec2& p) {
  return {double(p.x), double(p.y)};
}

inline glm::vec2 vec(const QPointF& p) {
  return {float(p.x()), float(p.y())};
}

}  // namespace sline::widgets
