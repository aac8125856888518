// SPDX-License-Identifier: Apache-2.0
// Lists sizes of paper and screens that a page may have.
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
  bool turns = true;  ///< the paper is turned like the page that it replaces
};
std::vector<PagePreset> pagePresets();

/// Returns the preset of that size, upright or turned, within a tenth of a millimetre.
std::optional<PagePreset> presetOf(const glm::vec2& sizeMm);

/// Returns the size turned upright or lying, as `as` is.
glm::vec2 turnedAs(const glm::vec2& size, const glm::vec2& as);

}  // namespace sline::widgets
