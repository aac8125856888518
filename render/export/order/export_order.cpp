// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/export_order.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sline::render {

Error givenUp(const std::filesystem::path& target) {
  return {.file = target.string(), .reason = "the export was stopped", .remedy = "Export again"};
}

std::string ExportCredit::line() const {
  return author + (author.empty() || copyright.empty() ? "" : ", ") + copyright;
}

glm::ivec2 pixelsOf(const ExportPage& page) {
  const auto side = [&page](float millimetres) {
    return std::max(int(std::lround(millimetres / millimetresPerInch * page.dpi)), 1);
  };
  return {side(page.sizeMm.x), side(page.sizeMm.y)};
}

int samplesAtOnce(const glm::ivec2& size) {
  constexpr std::int64_t fine = 8'000'000;
  return std::int64_t(size.x) * size.y > fine ? 1 : 2;
}

}  // namespace sline::render
