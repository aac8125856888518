// SPDX-License-Identifier: Apache-2.0
// Implements `sline steadiness`: measures whether hatching stays on the surface while the camera
// turns.
#include "render/measures/steadiness.h"

#include <algorithm>
#include <cstdio>

#include "app/cli/files/json_values.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/measure_options.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {

struct SteadinessFlags {
  MeasureFlags measure;
  std::string gamma = "3";
  int frames = 10;
  int oversampling = 4;
};

struct MeasuredSteadiness {
  std::string name;
  std::string group;
  render::Steadiness steadiness;
  std::vector<std::string> faults;
};

Json optionalNumber(const std::optional<double>& value) {
  return value ? Json(jsonNumber(float(*value))) : Json(nullptr);
}

Json flickerJson(const render::Flicker& flicker) {
  return {{"over_surface", jsonNumber(float(flicker.overSurface))},
          {"over_hatching", jsonNumber(float(flicker.overHatching))},
          {"hatched_share", jsonNumber(float(flicker.hatchedShare))},
          {"ink", jsonNumber(float(flicker.ink))},
          {"mid_tones", jsonNumber(float(flicker.midTones))},
          {"mid_tones_in_print", jsonNumber(float(flicker.midTonesInPrint))}};
}

Json steadinessJson(const MeasuredSteadiness& measured) {
  return {{"name", measured.name},
          {"group", measured.group},
          {"strokes", flickerJson(measured.steadiness.strokes)},
          {"as_printed", flickerJson(measured.steadiness.asPrinted)},
          {"ratio", optionalNumber(measured.steadiness.ratio())},
          {"ratio_over_hatching", optionalNumber(measured.steadiness.hatchedRatio())},
          {"ratio_per_ink", optionalNumber(measured.steadiness.inkRatio())},
          {"faults", measured.faults}};
}

void printFlicker(const char* name, const render::Flicker& flicker) {
  std::printf("  %-11s %8.4f %9.4f %8.1f %% %7.4f %8.1f %% %7.1f %%\n", name, flicker.overSurface,
              flicker.overHatching, 100.0 * flicker.hatchedShare, flicker.ink,
              100.0 * flicker.midTones, 100.0 * flicker.midTonesInPrint);
}

void printSteadiness(const MeasuredSteadiness& measured) {
  std::printf("%s\n  %-11s  surface  hatching  hatched     ink  mid-tones in print\n",
              measured.name.c_str(), "change of");
  printFlicker("strokes", measured.steadiness.strokes);
  printFlicker("as printed", measured.steadiness.asPrinted);
  const auto ratio = measured.steadiness.ratio();
  const auto hatched = measured.steadiness.hatchedRatio();
  const auto perInk = measured.steadiness.inkRatio();
  if (ratio && hatched && perInk)
    std::printf("  for as much ink %4.2f; plain %.2f, over hatching %.2f\n", *perInk, *ratio,
                *hatched);
  for (const std::string& fault : measured.faults)
    std::printf("  ✗ %s\n", fault.c_str());
  std::printf("\n");
}

Result<MeasuredSteadiness> measure(render::Picture& picture, const render::Subject& subject,
                                   Gamma gamma, const SteadinessFlags& flags) {
  const auto steadiness = TRY(measureSteadiness(
      picture.drawing(), subject,
      {.gamma = gamma, .frames = flags.frames, .oversampling = flags.oversampling}));
  MeasuredSteadiness measured{.name = subject.structure().name, .steadiness = steadiness};
  measured.faults = render::faults(measured.steadiness);
  return measured;
}

Exit runSteadiness(const SteadinessFlags& flags) {
  const Result<Gamma> gamma = parseGamma(flags.gamma);
  if (!gamma.ok())
    return complain(gamma.error(), Exit::wrongUse);
  Progress progress;
  bool wrongUse = false;
  const Result<MeasureSpec> spec = readMeasureSpec(flags.measure, progress, wrongUse);
  if (!spec.ok())
    return complain(spec.error(), wrongUse ? Exit::wrongUse : Exit::failed);
  const Result<render::HeadlessPicture> picture = render::HeadlessPicture::create();
  if (!picture.ok())
    return complain(picture.error(), Exit::failed);
  Json list = Json::array();
  bool passes = true;
  std::size_t done = 0;
  for (const model::NodeId id : spec->structures) {
    progress.show(double(done++) / double(spec->structures.size()), spec->scene.find(id)->name);
    const Result<render::Subject> subject = subjectOf(*spec, id);
    if (!subject.ok())
      return complain(subject.error(), Exit::wrongUse);
    Result<MeasuredSteadiness> measured = measure(**picture, *subject, *gamma, flags);
    progress.wipe();
    if (!measured.ok())
      return complain(measured.error(), Exit::failed);
    measured->group = spec->scene.groupPath(id);
    passes = passes && measured->faults.empty();
    if (flags.measure.json)
      list.push_back(steadinessJson(*measured));
    else
      printSteadiness(*measured);
  }
  if (flags.measure.json)
    std::printf("%s\n", jsonText({{"structures", list}, {"passes", passes}}, 2).c_str());
  return flags.measure.check && !passes ? Exit::failed : Exit::done;
}

void declareSteadiness(CLI::App& command, SteadinessFlags& flags) {
  addMeasureOptions(command, flags.measure);
  command.add_option("--gamma", flags.gamma, "At which gamma the structure is hatched")
      ->type_name("G")
      ->capture_default_str();
  command.add_option("--frames", flags.frames, "Turns of half a degree, 1 to 360")
      ->check(within(1, 360))
      ->capture_default_str();
  command
      .add_option(
          "--oversampling", flags.oversampling,
          "Draws strokes, which are the same drawing at any size, that many times as large and "
          "compares them at the size given, so that nothing is lost between pixels; 1 to 4")
      ->check(within(1, 4))
      ->capture_default_str();
  command.footer(
      "Turns the camera about the structure's middle in steps of half a degree, hatching alone, "
      "and\n"
      "moves each picture onto the next by depth and camera: what differs then, on average over "
      "the\n"
      "surface that both see, has not stayed on the surface. For as much ink strokes may change "
      "half\n"
      "as much as hatching as the paper prints it. Of the pixels with ink in print, a\n"
      "picture of the same sides 2160 pixels high (183 mm at 300 dpi), at most 25 % may be\n"
      "mid-tones, ink between 0.2 and 0.8: strokes have a definite edge. At the size given the\n"
      "share is told, but nothing is asked of it: on a screen thin strokes are nearly all edge,\n"
      "and an edge that is not softened crawls. `ink` is the mean ink on the surface: who draws\n"
      "less changes less.");
}

}  // namespace

void addSteadiness(CLI::App& program, Exit& exit) {
  addCommand<SteadinessFlags>(program, exit,
                              {"steadiness", "Measure how steady hatching is as the camera turns"},
                              declareSteadiness, runSteadiness);
}

}  // namespace sline::cli
