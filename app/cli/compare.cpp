// SPDX-License-Identifier: Apache-2.0
// Implements `sline compare`: draws models by several techniques side by side on a sheet.
#include <cstdio>
#include <filesystem>

#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/files/interruption.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/picture_options.h"
#include "model/anatomy/shown_names.h"
#include "model/scene/visible_structures.h"
#include "render/export/comparison/comparison_file.h"
#include "render/export/comparison/noisy_mesh.h"
#include "render/lettering/typesetting.h"
#include "render/lines/techniques/technique_list.h"

namespace sline::cli {

namespace {

constexpr const char* allTechniques = "all";

struct CompareFlags {
  InputFlags input;
  PictureFlags picture;
  std::vector<std::string> techniques{allTechniques};
  std::vector<std::string> noise;
  double cellMm = 42.0;
  double dpi = 300.0;
  bool json = false;
};

struct CompareSpec {
  model::ImportOptions import;
  PictureSpec picture;
  std::vector<render::Noise> noise;
  render::ComparisonOrder order;
};

Result<std::vector<model::Technique>> parseTechniques(const std::vector<std::string>& names) {
  std::vector<model::Technique> techniques;
  for (const std::string& name : names)
    if (name == allTechniques) {
      for (const render::TechniqueFacts& facts : render::techniqueList())
        if (facts.drawsLines())
          techniques.push_back(facts.technique);
    } else {
      const std::size_t place =
          TRY(parseName(model::namesOf(model::Technique()), "technique", name));
      if (!render::techniqueList()[place].drawsLines())
        return Error{.reason = name + " is made of pixels, and the sheet compares lines",
                     .remedy = "Leave it out; sline render draws it"};
      techniques.push_back(model::Technique(place));
    }
  return techniques;
}

Result<CompareSpec> parseCompareFlags(const CompareFlags& flags) {
  CompareSpec spec;
  spec.import = TRY(importOptions(flags.input));
  TRY(render::checkSheetName(flags.picture.output));
  PictureFlags picture = flags.picture;
  picture.size = "1000x1000";
  spec.picture = TRY(parseFlagsWithoutOutput(picture));
  spec.order.techniques = TRY(parseTechniques(flags.techniques));
  spec.order.thresholds = spec.picture.lineThresholds;
  spec.order.cellMm = float(flags.cellMm);
  for (const std::string& text : flags.noise) {
    const render::Noise noise = TRY(render::parseNoise(text));
    spec.noise.push_back(noise);
  }
  std::vector<std::string> read = flags.input.inputs;
  read.push_back(flags.picture.cameraFile);
  const Target sheet{.flag = "--output", .name = flags.picture.output, .endings = {}};
  TRY(checkTargets({&sheet, 1}, read));
  return spec;
}

/// Returns the model's name in the sheet: that of its only structure that is shown, else what may
/// be shown of its file's name.
std::string rowName(const model::Scene& scene, const std::string& input) {
  const std::vector<model::VisibleStructure> structures = model::visibleStructures(scene);
  if (structures.size() == 1)
    return structures.front().node->name;
  std::filesystem::path path(input);
  if (path.filename().empty())
    path = path.parent_path();
  const std::string shown = model::shownName(path.stem().string());
  return shown.empty() ? "model" : shown;
}

/// Appends the rows of one input: itself and, below it, roughened.
Status addRows(const std::string& input, const CompareFlags& flags, CompareSpec& spec,
               Progress& progress) {
  InputFlags one = flags.input;
  one.inputs = {input};
  const model::Imported imported = TRY(readInputs(one, spec.import, progress));
  const model::Scene seen = withSavedView(imported.scene, spec.picture);
  const model::Scene shown = TRY(styled(seen, spec.picture));
  const model::Camera camera = TRY(cameraFor(shown, spec.picture));
  const render::ComparedModel row{
      .name = rowName(shown, input), .note = {}, .scene = shown, .camera = camera};
  spec.order.models.push_back(row);
  for (const render::Noise& noise : spec.noise)
    spec.order.models.push_back(render::roughened(row, noise));
  return Unit{};
}

Json cellJson(const render::ComparedCell& cell, model::Technique technique,
              const model::ThresholdValues& values) {
  const render::TechniqueFacts& facts = render::factsOf(technique);
  Json thresholds = Json::object();
  for (const render::TechniqueThreshold& threshold : facts.thresholds)
    thresholds[threshold.id] = jsonNumber(render::valueOf(threshold, values));
  return {{"technique", facts.id},
          {"citation", facts.citation()},
          {"thresholds", thresholds},
          {"frame_ms", jsonNumber(float(cell.frameMs))},
          {"lines_per_mm", jsonNumber(float(cell.linesPerMm))}};
}

Json comparisonJson(const render::Comparison& comparison) {
  const render::ComparisonOrder& order = comparison.order;
  Json rows = Json::array();
  for (std::size_t row = 0; row < comparison.rows.size(); ++row) {
    Json cells = Json::array();
    for (std::size_t column = 0; column < order.techniques.size(); ++column)
      cells.push_back(
          cellJson(comparison.rows[row][column], order.techniques[column], order.thresholds));
    rows.push_back(
        {{"name", order.models[row].name}, {"note", order.models[row].note}, {"cells", cells}});
  }
  return {{"rows", rows}};
}

Exit runCompare(const CompareFlags& flags) {
  Result<CompareSpec> spec = parseCompareFlags(flags);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  Progress progress;
  for (const std::string& input : flags.input.inputs)
    if (const Status added = addRows(input, flags, *spec, progress); !added.ok()) {
      progress.wipe();
      return complain(added.error(), Exit::failed);
    }
  const auto typesetting = render::Typesetting::create();
  if (!typesetting.ok())
    return complain(typesetting.error(), Exit::failed);
  const Result<render::Comparison> comparison = render::compareTechniques(
      spec->order, render::ExportProgress([&progress](double share, std::string_view what) {
        progress.show(share, std::string(what));
        return true;
      }));
  progress.wipe();
  if (!comparison.ok())
    return complain(comparison.error(), Exit::failed);
  const Interruption interruption;  // what is written is soon whole
  const Status written = render::writeSheet(render::comparisonSheet(*comparison),
                                            flags.picture.output, float(flags.dpi));
  if (!written.ok())
    return complain(written.error(), Exit::failed);
  if (flags.json)
    std::printf("%s\n", jsonText(comparisonJson(*comparison), 2).c_str());
  return Exit::done;
}

void declareCompare(CLI::App& command, CompareFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  addTogether(command, flags.input);
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command
      .add_option("-o,--output", flags.picture.output,
                  "The sheet: svg and pdf with lines as lines and text as text, or png or tiff")
      ->required()
      ->type_name("FILE");
  command
      .add_option("--techniques", flags.techniques,
                  "The columns, in this order: all, or some of " +
                      CLI::detail::join(model::techniqueNames, ", "))
      ->delimiter(',')
      ->type_name("A,B,C")
      ->default_str(allTechniques);
  addLineThresholdOption(command, flags.picture);
  many(command.add_option(
           "--noise", flags.noise,
           "Below each model a row of the same with a rough surface: staircase moves vertices "
           "towards slices so many mean edges thick (usually 3), jitter moves each in a random "
           "direction, by so many mean edges (usually 0.1); may be given again"))
      ->type_name("staircase|jitter[=AMOUNT]");
  CLI::Option* view =
      command
          .add_option("--view", flags.picture.view,
                      "anterior, posterior, left, right, superior or inferior, fitted to each "
                      "model; or a saved view of the scenes; anterior if not given")
          ->type_name("NAME");
  addCameraOption(command, flags.picture, view);
  many(command.add_option("--only", flags.picture.only,
                          "Draws these structures and groups alone; may be given again"))
      ->type_name("NAME");
  command.add_option("--cell-mm", flags.cellMm, "Width and height of each picture in millimetres")
      ->type_name("MM")
      ->check(within(render::cellLimitsMm))
      ->capture_default_str();
  command.add_option("--dpi", flags.dpi, "Pixels to the inch, for png and tiff")
      ->type_name("N")
      ->check(within(render::dpiLimits))
      ->capture_default_str();
  command.add_flag("--json", flags.json,
                   "For programs: the figures as one JSON object on standard output");
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  command.add_option("--frame", flags.input.frame, frameHelp)->type_name("LPS|RAS|file");
  addThreshold(command, flags.input);
  command.footer(
      "Each INPUT is a row; a technique is drawn at the gamma at which all of its lines have\n"
      "entered. Below each picture stand its thresholds, the median time to find and join the\n"
      "lines of the view, and the length of the technique's visible lines, without contours, per\n"
      "area that the model covers, both as drawn.\n\n"
      "  sline compare liver.stl hip.ply 2src.pdb -o techniques.pdf\n"
      "  sline compare liver.stl -o noise.svg --techniques sline,laplacian,confis \\\n"
      "    --noise staircase --noise jitter=0.05 --line-threshold laplacian=3");
}

}  // namespace

void addCompare(CLI::App& program, Exit& exit) {
  addCommand<CompareFlags>(
      program, exit, {"compare", "Draw models by several line techniques side by side on a sheet"},
      declareCompare, runCompare);
}

}  // namespace sline::cli
