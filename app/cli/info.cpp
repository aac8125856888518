// SPDX-License-Identifier: Apache-2.0
// Implements `sline info`: prints what is in the files.
#include "app/cli/commands/command.h"
#include "app/cli/files/scene_summary.h"
#include "app/cli/flags/values.h"

namespace sline::cli {

namespace {

struct InfoFlags {
  InputFlags input;
  bool json = false;
};

void printJson(const SceneSummary& summary, const std::vector<model::ImportWarning>& warnings) {
  Json root = summaryJson(summary);
  root["warnings"] = Json::array();
  for (const model::ImportWarning& warning : warnings)
    root["warnings"].push_back({{"file", warning.file}, {"reason", warning.reason}});
  std::cout << jsonText(root, 2) << '\n';
}

Exit runInfo(const InfoFlags& flags) {
  Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  options->smoothing.mode = model::Smoothing::Mode::off;
  options->keepScans = true;
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  warnOfSides(imported->scene);
  const SceneSummary summary = summaryOf(imported->scene);
  if (flags.json)
    printJson(summary, imported->report.warnings);
  else
    printSummary(summary);
  return Exit::done;
}

void declareInfo(CLI::App& command, InfoFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_flag("--json", flags.json, "For programs: one JSON object on standard output");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  addThreshold(command, flags.input);
  command.footer(
      "Counts are of the surfaces as repaired on reading, without smoothing. Scans are listed "
      "with\n"
      "their voxels and intensities; --threshold makes structures of them.");
}

}  // namespace

void addInfo(CLI::App& program, Exit& exit) {
  addCommand<InfoFlags>(program, exit, {"info", "List structures, groups, sizes and warnings"},
                        declareInfo, runInfo);
}

}  // namespace sline::cli
