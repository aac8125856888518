// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/label_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "app/cli/files/export_notes.h"
#include "app/cli/files/names.h"
#include "app/cli/files/progress.h"
#include "render/export/order/common_options.h"

namespace sline::cli {

namespace {

/// Tells whether something that was asked for has found no place in the picture.
bool isLost(const render::ExportNote& note) {
  using Kind = render::ExportNote::Kind;
  return note.kind == Kind::marksWithoutRoom || note.kind == Kind::legendWithoutRoom ||
         note.kind == Kind::legendEmpty;
}

/// Returns the options of the marks at the picture's edges.
std::vector<const render::ExportOption*> markOptions() {
  std::vector<const render::ExportOption*> marks;
  for (const render::ExportOption* option : render::pictureOptions())
    if (option->group == render::OptionGroup::marks)
      marks.push_back(option);
  return marks;
}

/// Reads "on", "off" or a list of the marks that are wanted, as in "sides,scale".
Result<render::ExportMarks> parseMarks(const std::string& text) {
  if (text == "on")
    return render::ExportMarks();
  render::ExportOrder order;
  order.marks = render::ExportMarks::none();
  if (text == "off")
    return order.marks;
  const std::vector<const render::ExportOption*> marks = markOptions();
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = rest.substr(0, comma);
    const auto mark = std::find_if(marks.begin(), marks.end(),
                                   [&](const auto* known) { return known->flag == name; });
    if (mark == marks.end())
      return Error{.reason = "--marks " + text + " is unknown",
                   .remedy =
                       "Give on, off or some of sides, view, scale, sections, gamma and words, "
                       "as in sides,scale"};
    (*mark)->field.write(order, true);
    if (comma == std::string_view::npos)
      return order.marks;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

void declareLabels(CLI::App& command, LabelFlags& flags) {
  render::ExportOrder standard;
  standard.labels.mode = flags.mode;
  for (const render::ExportOption* option : render::pictureOptions())
    if (option->group == render::OptionGroup::labels)
      flags.options.declare(command, *option, {}, standard);
  command
      .add_option(
          "--marks", flags.marks,
          "What stands at the picture's edges: on, off, or some of sides (R and L, and the "
          "other sides of the body), view (its name), scale (a bar), sections (what they "
          "have taken away), gamma (by what it varies) and words (what a saved view says, in films "
          "as a subtitle), as in sides,scale")
      ->type_name("on|off|LIST")
      ->capture_default_str();
}

Result<LabelSpec> parseFlags(const LabelFlags& flags) {
  const render::ExportMarks marks = TRY(parseMarks(flags.marks));
  render::ExportOrder order;
  order.labels.mode = flags.mode;
  TRY(flags.options.applyTo(order));
  LabelSpec labels;
  labels.marks = marks;
  labels.style = order.labels;
  labels.legend = order.legend;
  return labels;
}

void warnOfNoLabels(const LabelFlags& flags, const model::Scene& scene) {
  const Result<LabelSpec> asked = parseFlags(flags);
  if (asked.ok() && asked->style.mode != flags.mode &&
      asked->style.mode != render::LabelMode::off && scene.annotations().empty())
    warn(
        "--labels draws nothing, as the scene has no labels. Make them in a scene file with `sline "
        "annotate`");
}

void LabelSpec::writeTo(render::ExportOrder& order) const {
  order.labels = style;
  order.marks = marks;
  order.legend = legend;
}

Status prepareLabels(LabelSpec& spec, const model::Scene& scene, const glm::vec2& pageMm) {
  render::ExportOrder job;
  job.sources = spec.sources;
  spec.writeTo(job);
  if (job.bare())
    return Unit{};
  spec.typesetting = TRY(render::Typesetting::create());
  job.scene = scene;
  if (const auto view = model::anatomicalViewNamed(model::normalisedName(spec.viewName)))
    job.camera = model::anatomicalCamera(*view, scene.visibleBounds(), pageMm.x / pageMm.y);
  job.page.sizeMm = pageMm;
  spec.sides = render::sidesOfPlate(job, *spec.typesetting);
  return Unit{};
}

void drawLabels(render::Image& image, const model::Scene& scene, const model::Camera& camera,
                const LabelSpec& spec, render::Background background) {
  if (!spec.typesetting)
    return;
  render::ExportOrder job;
  job.scene = scene;
  job.camera = camera;
  job.viewName = spec.viewName;
  job.words = spec.words;
  job.page.sizeMm.y = render::usualHeightMm;
  job.environment.background = background;
  spec.writeTo(job);
  const render::LabelReport report = render::drawPlate(image, job, *spec.typesetting);
  for (const std::string& text : report.leftOut)
    warn("there is no room for the label \"" + onOneLine(text) + "\"");
  for (const render::ExportNote& note : report.marks)
    if (isLost(note))
      warn(textOf(note));
  if (spec.style.mode == render::LabelMode::numbers)
    printKey(report);
}

void printKey(const render::LabelReport& report) {
  for (const render::LabelReport::Line& line : report.key)
    std::cout << line.number << '\t' << onOneLine(line.text) << '\n';
}

}  // namespace sline::cli
