// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/export_order.h"

#include <algorithm>
#include <cmath>

namespace sline::render {

Error givenUp(const std::filesystem::path& target) {
  return {.file = target.string(), .reason = "the export was stopped", .remedy = "Export again"};
}

std::string ExportCredit::line() const {
  return author + (author.empty() || copyright.empty() ? "" : ", ") + copyright;
}

glm::ivec2 pixelsOf(const ExportPage& page) {
  constexpr float millimetresPerInch = 25.4f;
  const auto side = [&page](float millimetres) {
    return std::max(int(std::lround(millimetres / millimetresPerInch * page.dpi)), 1);
  };
  return {side(page.sizeMm.x), side(page.sizeMm.y)};
}

}  // namespace sline::render
