// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/scene_input.h"

#include <algorithm>

#include "app/cli/flags/values.h"
#include "model/edit/settled_units.h"

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

/// Says how a doubted unit is settled.
void tellUnits(const model::ImportReport& report) {
  for (const model::UnitDoubt& doubt : report.unitDoubts) {
    std::string flags;
    for (const float unit : doubt.units)
      flags += (flags.empty() ? "" : " or ") + unitFlag(unit);
    tell((flags.empty() ? "" : "`sline import` with " + flags + " takes it so; ") + "with " +
         unitFlag(doubt.unit) + " its size is right as it is, and scale bars stand without \"?\"");
  }
}
}  // namespace

Result<std::optional<model::SideAnswer>> parseSides(const std::string& text) {
  if (text.empty())
    return std::optional<model::SideAnswer>();
  const auto index = TRY(parseName(model::sideAnswerNames, "--sides", text));
  return std::optional(model::SideAnswer(index));
}

Result<model::ImportOptions> importOptions(const InputFlags& flags) {
  model::ImportOptions options;
  TRY(parseSides(flags.sides));
  if (!flags.frame.empty()) {
    options.frame = TRY(parseFrame(flags.frame));
  }
  if (!flags.unit.empty()) {
    const auto unit = TRY(parseUnit(flags.unit));
    if (options.frame == model::Frame::file)
      return Error{.reason = "--frame file leaves coordinates as they are, whatever their unit",
                   .remedy = "Leave out one of --frame and --unit"};
    options.unit = unit;
  }
  if (!flags.overlay.empty() && flags.overlay != "auto" && flags.overlay != "off")
    return Error{.reason = "--overlay " + flags.overlay + " is unknown",
                 .remedy = "Give --overlay auto or --overlay off"};
  if (flags.overlay == "off")
    options.overlay = model::Overlay::off;
  options.assembly = flags.assembly;
  if (!flags.smooth.empty()) {
    options.smoothing = TRY(parseSmoothing(flags.smooth));
  }
  for (const std::string& text : flags.thresholds) {
    const auto threshold = TRY(parseThreshold(text));
    options.thresholds.push_back(threshold);
  }
  options.keepScans = flags.keepScans;
  if (flags.together)
    options.patients = model::PatientsWanted::together;
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
  if (imported->report.unitDoubts.empty() && model::hasDoubtedUnits(imported->scene))
    warn(
        "nobody has said how long the unit of its files is, and not all has the size that it "
        "should have: lengths stand with a \"?\"");
  tellUnits(imported->report);
  tellNotes(imported->report, flags.verbose);
  if (const auto sides = parseSides(flags.sides); sides.ok() && *sides) {
    if (model::hasDoubtedSides(imported->scene) || model::hasDoubtedNames(imported->scene))
      imported->scene = model::withSidesSettled(imported->scene, **sides).scene;
    else if (**sides != model::SideAnswer::right)
      warn("no sides are in doubt, so --sides changes nothing; --frame overrules what files say");
  }
  return imported;
}

void warnOfSides(const model::Scene& scene) {
  if (!model::hasDoubtedSides(scene))
    return;
  const auto doubted = [](const model::Node& node) {
    return !node.isGroup() && !node.provenance.evidence.isSure();
  };
  const auto& nodes = scene.nodes();
  const auto first = std::find_if(nodes.begin(), nodes.end(), doubted);
  const auto count = std::count_if(nodes.begin(), nodes.end(), doubted);
  const bool onlyFront = model::isOnlyFrontDoubted(scene);
  const bool onlyUp = model::isOnlyUpDoubted(scene);
  std::string text = onlyUp      ? "which way leads to the head is not certain"
                     : onlyFront ? "front and back are not certain"
                                 : "left and right are not certain";
  if (first != nodes.end())
    text += " of " + std::to_string(count) + (count == 1 ? " structure (" : " structures (") +
            first->provenance.frame + ": " + first->provenance.frameReason + ")";
  warn(text + (onlyUp ? "; marks of above and below carry a question mark until --sides right "
                        "settles it"
               : onlyFront
                   ? "; marks of front and back carry a question mark until --sides right, or "
                     "mirror where they are swapped, or --frame, settles it"
                   : "; marks of the sides carry a question mark until --sides right, mirror "
                     "or turn, or --frame, settles it"));
}

Result<model::SceneDocument> openedScene(const std::string& file) {
  Result<model::SceneDocument> document = model::readSceneFile(file);
  if (document.ok())
    if (const std::string warning = document->warning(); !warning.empty())
      warn(file + ": " + warning);
  return document;
}

}  // namespace sline::cli
