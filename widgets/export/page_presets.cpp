// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/page_presets.h"

#include <cmath>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

bool alike(const glm::vec2& a, const glm::vec2& b) {
  constexpr float nearly = 0.1f;
  return std::abs(a.x - b.x) < nearly && std::abs(a.y - b.y) < nearly;
}

}  // namespace

std::vector<PagePreset> pagePresets() {
  return {{QStringLiteral("a5"), tr("A5"), {148.0f, 210.0f}},
          {QStringLiteral("a4"), tr("A4"), {210.0f, 297.0f}},
          {QStringLiteral("a3"), tr("A3"), {297.0f, 420.0f}},
          {QStringLiteral("letter"), tr("US Letter"), {215.9f, 279.4f}},
          {QStringLiteral("slide"), tr("Slide 16:9"), {338.7f, 190.5f}, false},
          {QStringLiteral("column"), tr("Journal column"), {60.0f, 85.0f}},
          {QStringLiteral("a1"), tr("A1 poster"), {594.0f, 841.0f}}};
}

std::optional<PagePreset> presetOf(const glm::vec2& sizeMm) {
  for (const PagePreset& preset : pagePresets())
    if (alike(preset.sizeMm, sizeMm) || alike(preset.sizeMm, {sizeMm.y, sizeMm.x}))
      return preset;
  return std::nullopt;
}

glm::vec2 turnedAs(const glm::vec2& size, const glm::vec2& as) {
  const bool turned = (size.x > size.y) != (as.x > as.y);
  return turned ? glm::vec2(size.y, size.x) : size;
}

}  // namespace sline::widgets
