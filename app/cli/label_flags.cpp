// SPDX-License-Identifier: Apache-2.0
#include "app/cli/label_flags.h"

#include <iostream>

#include "app/cli/progress.h"

namespace sline::cli {

using render::LabelMode;

Result<LabelOrder> understood(const LabelFlags& flags) {
  static constexpr std::array<std::pair<std::string_view, LabelMode>, 4> modes{
      {{"off", LabelMode::off},
       {"on", LabelMode::on},
       {"numbers", LabelMode::numbers},
       {"blank", LabelMode::blank}}};
  LabelOrder order;
  order.style.language = flags.language;
  order.style.points = float(flags.points);
  for (const auto& [name, mode] : modes)
    if (name == flags.mode) {
      order.style.mode = mode;
      return order;
    }
  return Error{.reason = "--labels " + flags.mode + " is unknown",
               .remedy = "Give on, off, numbers or blank"};
}

Status prepareLabels(LabelOrder& order, const model::Scene& scene, float aspect) {
  if (order.style.mode == LabelMode::off)
    return Unit{};
  Result<std::unique_ptr<render::Typesetting>> made = render::Typesetting::create();
  if (!made.ok())
    return made.error();
  order.typesetting = std::move(*made);
  order.anatomyShare =
      render::shareBesideLabels({.scene = scene, .style = order.style}, aspect, *order.typesetting);
  return Unit{};
}

void drawLabels(render::Image& image, const model::Scene& scene, const model::Camera& camera,
                const LabelOrder& order) {
  if (order.style.mode == LabelMode::off || !order.typesetting)
    return;
  const render::LabelReport report = render::drawLabels(
      image, {.scene = scene, .camera = camera, .style = order.style}, *order.typesetting);
  for (const std::string& text : report.leftOut)
    warn("there is no room for the label \"" + text + "\"");
  if (order.style.mode == LabelMode::numbers)
    for (const render::LabelReport::Line& line : report.key)
      std::cout << line.number << '\t' << line.text << '\n';
}

}  // namespace sline::cli
