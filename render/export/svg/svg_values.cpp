// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_values.h"

#include <cstdint>
#include <string_view>

#include "render/export/svg/svg_path.h"

namespace sline::render {

std::string number(double value, int decimals) {
  std::string text;
  appendNumber(text, value, decimals);
  return text;
}

std::string opacityAttribute(float opacity) {
  return opacity < 0.999f ? " opacity=\"" + number(double(opacity), 3) + "\"" : std::string();
}

}  // namespace sline::render
