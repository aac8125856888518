// SPDX-License-Identifier: Apache-2.0
#include "app/cli/label_flags.h"

#include <algorithm>
#include <array>
#include <iostream>

#include "app/cli/names.h"
#include "app/cli/progress.h"

namespace sline::cli {

using render::LabelMode;

namespace {

/// "on", "off" or those that are wanted, as in "sides,scale".
Result<render::ExportMarks> parseMarks(const std::string& text) {
  if (text == "on")
    return render::ExportMarks();
  render::ExportMarks marks = render::ExportMarks::none();
  if (text == "off")
    return marks;
  static constexpr std::array<std::pair<std::string_view, bool render::ExportMarks::*>, 4> kinds{
      {{"sides", &render::ExportMarks::sides},
       {"view", &render::ExportMarks::viewName},
       {"scale", &render::ExportMarks::scaleBar},
       {"sections", &render::ExportMarks::sectionState}}};
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = rest.substr(0, comma);
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                   [&](const auto& known) { return known.first == name; });
    if (kind == kinds.end())
      return Error{.reason = "--marks " + text + " is unknown",
                   .remedy =
                       "Give on, off or some of sides, view, scale and sections, as in "
                       "sides,scale"};
    marks.*(kind->second) = true;
    if (comma == std::string_view::npos)
      return marks;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

Result<LabelOrder> understood(const LabelFlags& flags) {
  static constexpr std::array<std::pair<std::string_view, LabelMode>, 4> modes{
      {{"off", LabelMode::off},
       {"on", LabelMode::on},
       {"numbers", LabelMode::numbers},
       {"blank", LabelMode::blank}}};
  const Result<render::ExportMarks> marks = parseMarks(flags.marks);
  if (!marks.ok())
    return marks.error();
  LabelOrder order;
  order.marks = *marks;
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

Status prepareLabels(LabelOrder& order, const model::Scene& scene, const glm::vec2& pageMm) {
  if (order.bare())
    return Unit{};
  Result<std::unique_ptr<render::Typesetting>> made = render::Typesetting::create();
  if (!made.ok())
    return made.error();
  order.typesetting = std::move(*made);
  render::ExportOrder job;
  job.scene = scene;
  if (const auto view = model::anatomicalViewNamed(model::normalisedName(order.viewName)))
    job.camera = model::anatomicalCamera(*view, scene.visibleBounds(), pageMm.x / pageMm.y);
  job.page.sizeMm = pageMm;
  job.labels = order.style;
  job.marks = order.marks;
  order.sides = render::sidesOfPlate(job, *order.typesetting);
  return Unit{};
}

void drawLabels(render::Image& image, const model::Scene& scene, const model::Camera& camera,
                const LabelOrder& order, render::Background background) {
  if (!order.typesetting)
    return;
  render::ExportOrder job;
  job.scene = scene;
  job.camera = camera;
  job.viewName = order.viewName;
  job.page.sizeMm.y = render::usualHeightMm;
  job.look.background = background;
  job.labels = order.style;
  job.marks = order.marks;
  const render::LabelReport report = render::drawPlate(image, job, *order.typesetting);
  for (const std::string& text : report.leftOut)
    warn("there is no room for the label \"" + onOneLine(text) + "\"");
  if (order.style.mode == LabelMode::numbers)
    printKey(report);
}

void printKey(const render::LabelReport& report) {
  for (const render::LabelReport::Line& line : report.key)
    std::cout << line.number << '\t' << onOneLine(line.text) << '\n';
}

}  // namespace sline::cli
