// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/export_order.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/edit/look.h"

namespace sline::render {

void drawInInk(ExportOrder& order) {
  auto coloured = std::make_shared<const model::Scene>(order.scene);
  model::Edited inked = model::withInkAlone(order.scene);
  // Of ink that is drawn in ink again the colours are known already.
  if (inked.changed || !order.inColour)
    order.inColour = std::move(coloured);
  order.scene = std::move(inked.scene);
}

model::Scene writtenScene(const ExportOrder& order) {
  if (!order.inColour)
    return order.scene;
  const auto sameNode = [](const model::Node& one, const model::Node& other) {
    return one.id == other.id;
  };
  const auto& nodes = order.scene.nodes();
  const auto& coloured = order.inColour->nodes();
  if (!std::equal(nodes.begin(), nodes.end(), coloured.begin(), coloured.end(), sameNode))
    return order.scene;
  model::Scene written = *order.inColour;
  written.setAnnotations(order.scene.annotations());
  return written;
}

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
