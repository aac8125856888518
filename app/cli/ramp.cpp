// SPDX-License-Identifier: Apache-2.0
// Implements `sline ramp`: measures whether the way from silhouette to shaded surface is seamless.
#include "render/measures/ramp.h"
#include "render/export/pixels/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/cli/files/json_values.h"
#include "app/cli/files/targets.h"
#include "app/cli/measure_options.h"
#include "render/measures/contact_sheet.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {

constexpr std::size_t mostOnASheet = 12;

struct RampFlags {
  MeasureFlags measure;
  std::string sheet;
};

struct MeasuredRamp {
  std::string name;
  std::string group;
  render::Ramp ramp;
  std::vector<std::string> faults;
};

Json numbers(std::span<const double> values) {
  Json list = Json::array();
  for (const double value : values)
    list.push_back(jsonNumber(float(value)));
  return list;
}

Json stageJson(const render::RampStage& stage, std::size_t s) {
  return {{"from", s},
          {"to", s + 1},
          {"mean", jsonNumber(float(stage.mean))},
          {"whole", jsonNumber(float(stage.whole))},
          {"end_to_end", jsonNumber(float(stage.endToEnd))},
          {"exempt", stage.exempt()},
          {"largest", jsonNumber(float(stage.largest))},
          {"largest_at", jsonNumber(float(stage.largestAt))},
          {"jumps", stage.jumps()},
          {"weakest", jsonNumber(float(stage.weakest))},
          {"weakest_at", jsonNumber(float(stage.weakestAt))},
          {"dead", numbers(stage.dead)},
          {"stalls", stage.stalls()},
          {"timing", numbers(stage.timing)}};
}

Json rampJson(const MeasuredRamp& measured) {
  const render::Ramp& ramp = measured.ramp;
  Json stages = Json::array();
  for (std::size_t s = 0; s < ramp.stages.size(); ++s)
    stages.push_back(stageJson(ramp.stages[s], s));
  const render::RampTone& tone = ramp.tone;
  return {{"name", measured.name},
          {"group", measured.group},
          {"area", {ramp.area.x, ramp.area.y, ramp.area.width, ramp.area.height}},
          {"pixels", ramp.pixels},
          {"stages", stages},
          {"tone",
           {{"at_5", jsonNumber(float(tone.atEnd()))},
            {"lowest", jsonNumber(float(tone.lowest))},
            {"lowest_at", jsonNumber(float(tone.lowestAt))},
            {"too_dark", tone.tooDark()},
            {"bump", jsonNumber(float(tone.bump.height))},
            {"bump_at", jsonNumber(render::rampGamma(tone.bump.at).value())},
            {"turns_back", tone.turnsBack()},
            {"bumped_pixels", jsonNumber(float(tone.bumpedPixels))},
            {"bumped_by_stage", numbers(tone.bumpedByStage)}}},
          {"fill",
           {{"largest_fall", jsonNumber(float(ramp.fill.largestFall))},
            {"fall_at", jsonNumber(float(ramp.fill.fallAt))},
            {"fallen_pixels", jsonNumber(float(ramp.fill.fallenPixels))},
            {"open_at_5", jsonNumber(float(ramp.fill.openAtEnd))}}},
          {"steps", numbers(ramp.steps)},
          {"luminance", numbers(tone.luminance)},
          {"faults", measured.faults}};
}

/// Returns a character for each step: its change as a multiple of the stage's mean.
std::string profile(std::span<const double> steps, double mean) {
  constexpr std::array<const char*, 8> bars{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  std::string text;
  for (const double step : steps) {
    const double rate = mean > 0.0 ? step / mean : 0.0;
    if (rate < render::deadLimit)
      text += "·";
    else if (rate > render::jumpLimit)
      text += "!";
    else
      text += bars[std::size_t(rate / render::jumpLimit * 7.999)];
  }
  return text;
}

void printStage(const MeasuredRamp& measured, std::size_t s) {
  constexpr std::array<const char*, render::rampStages> names{"inner contours", "suggestive",
                                                              "hatching", "shading", "fill closes"};
  const render::RampStage& stage = measured.ramp.stages[s];
  const auto steps =
      std::span(measured.ramp.steps).subspan(s * render::stepsPerStage, render::stepsPerStage);
  const char* verdict = stage.exempt()                    ? "exempt"
                        : stage.jumps() && stage.stalls() ? "JUMPS, STALLS"
                        : stage.jumps()                   ? "JUMPS"
                        : stage.stalls()                  ? "STALLS"
                                                          : "even";
  std::printf("  %zu–%zu %-14s %s  %7.4f %7.4f  %5.2f at %4.2f  %3.0f %% at %4.2f  %s\n", s, s + 1,
              names[s], profile(steps, stage.mean).c_str(), stage.whole, stage.endToEnd,
              stage.largest, stage.largestAt, 100.0 * stage.weakest, stage.weakestAt, verdict);
}

void printTiming(const render::Ramp& ramp) {
  std::printf("  T at which 10 … 90 %% of a stage is done (even: .10 … .90)\n");
  for (std::size_t s = 0; s < ramp.stages.size(); ++s) {
    std::printf("    %zu–%zu", s, s + 1);
    for (const double t : ramp.stages[s].timing)
      std::printf("  %.3f", t);
    std::printf("\n");
  }
}

void printRamp(const MeasuredRamp& measured) {
  const render::Ramp& ramp = measured.ramp;
  std::printf("%s  (%d×%d pixels)\n", measured.name.c_str(), ramp.area.width, ramp.area.height);
  std::printf(
      "  stage              rate: · under 20 %%   change end–end  largest×mean  "
      "weakest 0.1    \n");
  for (std::size_t s = 0; s < ramp.stages.size(); ++s)
    printStage(measured, s);
  printTiming(ramp);
  const render::RampTone& tone = ramp.tone;
  std::printf("  tone  luminance at 5: %.3f, lowest %.1f %% of it at %.2f; at 0 … 5:", tone.atEnd(),
              100.0 * tone.lowest, tone.lowestAt);
  for (int i = 0; i <= render::rampSteps; i += render::stepsPerStage / 2)
    std::printf(" %.3f", tone.luminance[std::size_t(i)]);
  std::printf(
      "\n        lighter, then darker again by %.1f %% at %.2f; so do %.1f %% of pixels "
      "(by stage",
      100.0 * tone.bump.height, render::rampGamma(tone.bump.at).value(), 100.0 * tone.bumpedPixels);
  for (const double share : tone.bumpedByStage)
    std::printf(" %.1f", 100.0 * share);
  std::printf(")\n  fill  falls by %.3f at most (%.2f %% of pixels, at %.2f); open at 5: %.2f %%\n",
              ramp.fill.largestFall, 100.0 * ramp.fill.fallenPixels, ramp.fill.fallAt,
              100.0 * ramp.fill.openAtEnd);
  for (const std::string& fault : measured.faults)
    std::printf("  ✗ %s\n", fault.c_str());
  std::printf("\n");
}

/// Prints one row for each structure, and the mean timing of all that are not exempt.
void printSummary(const std::vector<MeasuredRamp>& all) {
  std::size_t widest = 9;
  for (const MeasuredRamp& measured : all)
    widest = std::max(widest, measured.name.size());
  std::printf("%-*s  largest × mean, 0–1 … 4–5   weakest 0.1 in %%       darkest  bump  faults\n",
              int(widest), "structure");
  for (const MeasuredRamp& measured : all) {
    std::printf("%-*s ", int(widest), measured.name.c_str());
    for (const render::RampStage& stage : measured.ramp.stages)
      stage.exempt() ? std::printf("   – ") : std::printf(" %4.1f", stage.largest);
    std::printf("  ");
    for (const render::RampStage& stage : measured.ramp.stages)
      stage.exempt() ? std::printf("   – ") : std::printf(" %4.0f", 100.0 * stage.weakest);
    std::printf("   %5.1f %5.1f  %zu\n", 100.0 * measured.ramp.tone.lowest,
                100.0 * measured.ramp.tone.bump.height, measured.faults.size());
  }
  std::printf("mean T at which 10 … 90 %% of a stage is done\n");
  for (std::size_t s = 0; s < std::size_t(render::rampStages); ++s) {
    std::printf("  %zu–%zu", s, s + 1);
    std::array<double, 9> sum{};
    int count = 0;
    for (const MeasuredRamp& measured : all)
      if (const render::RampStage& stage = measured.ramp.stages[s]; !stage.exempt()) {
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += stage.timing[i];
        ++count;
      }
    for (const double t : sum)
      count > 0 ? std::printf("  %.3f", t / count) : std::printf("      –");
    std::printf("  (%d)\n", count);
  }
}

Result<MeasuredRamp> measure(render::Picture& picture, const render::Subject& subject,
                             std::vector<render::SheetPicture>* sheet) {
  std::array<render::SheetPicture, 2 * render::rampStages + 1> halves;
  const auto look = [&](Gamma gamma, const render::Image& image) {
    const float twice = 2.0f * gamma.value();
    if (sheet && twice == std::floor(twice)) {
      std::array<char, 8> label{};
      std::snprintf(label.data(), label.size(), "%.1f", gamma.value());
      halves[std::size_t(twice)] = {label.data(), image};
    }
  };
  Result<render::Ramp> ramp =
      render::measureRamp(render::rampPictures(picture.drawing(), subject, look));
  if (!ramp.ok()) {
    Error error = ramp.error();
    error.where = subject.structure().name;
    return error;
  }
  if (sheet)
    sheet->assign(std::move_iterator(halves.begin()), std::move_iterator(halves.end()));
  MeasuredRamp measured{.name = subject.structure().name, .ramp = std::move(*ramp)};
  measured.faults = render::faults(measured.ramp);
  return measured;
}

/// Appends a structure's pictures and diagram below what the sheet holds.
void appendSheet(render::Image& sheet, std::span<const render::SheetPicture> pictures,
                 const render::Ramp& ramp) {
  const render::Image row = render::contactSheet(pictures, 6);
  const render::Image whole =
      render::stacked(row, render::rampDiagram(ramp, row.width, std::max(120, row.height / 4)));
  sheet = sheet.rgba.empty() ? whole : render::stacked(sheet, whole);
}

struct RampReport {
  std::vector<MeasuredRamp> structures;
  render::Image sheet;

  bool passes() const {
    return std::all_of(structures.begin(), structures.end(),
                       [](const MeasuredRamp& measured) { return measured.faults.empty(); });
  }
};

/// Measures one structure after the other and prints each as soon as it is known, unless all go
/// into one JSON object. Returns an exit code if it cannot go on.
std::optional<Exit> measureAll(const MeasureSpec& spec, const RampFlags& flags, Progress& progress,
                               RampReport& report) {
  const Result<render::HeadlessPicture> picture = render::HeadlessPicture::create();
  if (!picture.ok())
    return complain(picture.error(), Exit::failed);
  std::vector<render::SheetPicture> pictures;
  for (const model::NodeId id : spec.structures) {
    progress.show(double(report.structures.size()) / double(spec.structures.size()),
                  spec.scene.find(id)->name);
    const Result<render::Subject> subject = subjectOf(spec, id);
    if (!subject.ok())
      return complain(subject.error(), Exit::wrongUse);
    Result<MeasuredRamp> measured =
        measure(**picture, *subject, flags.sheet.empty() ? nullptr : &pictures);
    progress.wipe();
    if (!measured.ok())
      return complain(measured.error(), Exit::failed);
    measured->group = spec.scene.groupPath(id);
    if (!flags.sheet.empty())
      appendSheet(report.sheet, pictures, measured->ramp);
    if (!flags.measure.json)
      printRamp(*measured);
    report.structures.push_back(std::move(*measured));
  }
  return std::nullopt;
}

Status checkSheet(const RampFlags& flags) {
  if (flags.sheet.empty())
    return Unit{};
  TRY(render::checkImageName(flags.sheet));
  std::vector<std::string> read = flags.measure.input.inputs;
  read.push_back(flags.measure.cameraFile);
  const Target sheet{.flag = "--sheet", .name = flags.sheet, .endings = {}};
  return checkTargets({&sheet, 1}, read);
}

Exit runRamp(const RampFlags& flags) {
  if (const Status named = checkSheet(flags); !named.ok())
    return complain(named.error(), Exit::wrongUse);
  Progress progress;
  bool wrongUse = false;
  const Result<MeasureSpec> spec = readMeasureSpec(flags.measure, progress, wrongUse);
  if (!spec.ok())
    return complain(spec.error(), wrongUse ? Exit::wrongUse : Exit::failed);
  if (!flags.sheet.empty() && spec->structures.size() > mostOnASheet)
    return complain({.reason = "a sheet of " + std::to_string(spec->structures.size()) +
                               " structures is too large to look at",
                     .remedy = "Name at most " + std::to_string(mostOnASheet) + " structures"},
                    Exit::wrongUse);
  RampReport report;
  if (const auto stopped = measureAll(*spec, flags, progress, report))
    return *stopped;
  if (!flags.sheet.empty())
    if (const Status written = render::writeImage(report.sheet, flags.sheet); !written.ok())
      return complain(written.error(), Exit::failed);
  if (flags.measure.json) {
    Json list = Json::array();
    for (const MeasuredRamp& measured : report.structures)
      list.push_back(rampJson(measured));
    std::printf("%s\n", jsonText({{"structures", list}, {"passes", report.passes()}}, 2).c_str());
  } else if (report.structures.size() > 1) {
    printSummary(report.structures);
  }
  return flags.measure.check && !report.passes() ? Exit::failed : Exit::done;
}

void declareRamp(CLI::App& command, RampFlags& flags) {
  addMeasureOptions(command, flags.measure);
  command
      .add_option("--sheet", flags.sheet,
                  "Also writes the pictures at gamma 0, 0.5 … 5 side by side, with a diagram")
      ->type_name("FILE.png");
  command.footer(
      "Draws the structure at gamma 0, 0.05 … 5 on white. In each stage (unit of gamma) no step "
      "may\n"
      "change the picture by more than 3 times the stage's mean, and every 0.1 must change it by\n"
      "20 % of the mean rate; stages that change it by less than 0.002 are exempt. The structure\n"
      "must not be more than 2 % darker than at 5, nor turn lighter and then darker again by more\n"
      "than that; fills only grow, and are closed at 5.");
}

}  // namespace

void addRamp(CLI::App& program, Exit& exit) {
  addCommand<RampFlags>(program, exit, {"ramp", "Measure how evenly gamma changes a picture"},
                        declareRamp, runRamp);
}

}  // namespace sline::cli
