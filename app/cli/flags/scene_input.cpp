// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/scene_input.h"

#include "app/cli/flags/values.h"

namespace sline::cli {

namespace {
/// Prints the notes of an import and, if asked for, each surface that was repaired.
void tellNotes(const model::ImportReport& report, bool verbose) {
  for (const std::string& note : report.notes)
    tell(note);
  if (!report.repairs.summary.empty())
    tell(report.repairs.summary + (verbose ? "" : "; --verbose lists them"));
  if (verbose)
    for (const std::string& surface : report.repairs.surfaces)
      tell("  " + surface);
}
}  // namespace

Result<model::ImportOptions> importOptions(const InputFlags& flags) {
  model::ImportOptions options;
  if (!flags.frame.empty()) {
    const auto frame = parseFrame(flags.frame);
    if (!frame.ok())
      return frame.error();
    options.frame = *frame;
  }
  if (!flags.unit.empty()) {
    const auto unit = parseUnit(flags.unit);
    if (!unit.ok())
      return unit.error();
    if (options.frame == model::Frame::file)
      return Error{.reason = "--frame file leaves coordinates as they are, whatever their unit",
                   .remedy = "Leave out one of --frame and --unit"};
    options.unit = *unit;
  }
  if (!flags.overlay.empty() && flags.overlay != "auto" && flags.overlay != "off")
    return Error{.reason = "--overlay " + flags.overlay + " is unknown",
                 .remedy = "Give --overlay auto or --overlay off"};
  if (flags.overlay == "off")
    options.overlay = model::Overlay::off;
  options.assembly = flags.assembly;
  if (!flags.smooth.empty()) {
    const auto smoothing = parseSmoothing(flags.smooth);
    if (!smoothing.ok())
      return smoothing.error();
    options.smoothing = *smoothing;
  }
  for (const std::string& text : flags.thresholds) {
    const auto threshold = parseThreshold(text);
    if (!threshold.ok())
      return threshold.error();
    options.thresholds.push_back(*threshold);
  }
  options.keepScans = flags.keepScans;
  options.keepFileNames = flags.keepFileNames;
  options.decimateMm = float(flags.decimateMm);
  return options;
}

Result<model::Imported> readInputs(const InputFlags& flags, const model::ImportOptions& options,
                                   Progress& progress) {
  const std::vector<std::filesystem::path> paths(flags.inputs.begin(), flags.inputs.end());
  auto imported =
      model::importInputs(paths, options, [&progress](double done, const std::string& what) {
        progress.show(done, what);
        return true;
      });
  progress.wipe();
  if (!imported.ok())
    return imported;
  for (const model::ImportWarning& warning : imported->report.warnings)
    warn(warning.file.empty() ? warning.reason : warning.file + ": " + warning.reason);
  tellNotes(imported->report, flags.verbose);
  return imported;
}

Result<model::SceneDocument> openedScene(const std::string& file) {
  Result<model::SceneDocument> document = model::readSceneFile(file);
  if (document.ok())
    if (const std::string warning = document->warning(); !warning.empty())
      warn(file + ": " + warning);
  return document;
}

}  // namespace sline::cli
