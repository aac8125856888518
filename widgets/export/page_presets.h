// SPDX-License-Identifier: Apache-2.0
// Sizes of paper and screens, and what a page may have.
#pragma once

#include <QString>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace sline::widgets {

struct PagePreset {
  QString id;
  QString text;
  glm::vec2 sizeMm;
  bool turns = true;  ///< paper lies as the page does that it replaces
};
std::vector<PagePreset> pagePresets();

/// The preset of that size, upright or turned, within a tenth of a millimetre.
std::optional<PagePreset> presetOf(const glm::vec2& sizeMm);

/// Upright or lying, as `as` is.
glm::vec2 turnedAs(const glm::vec2& size, const glm::vec2& as);

}  // namespace sline::widgets
