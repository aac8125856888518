// SPDX-License-Identifier: Apache-2.0
// Implements `sline import`: reads any known file and writes a scene file.
#include "app/cli/commands/command.h"
#include "app/cli/files/targets.h"
#include "app/cli/files/thumbnail.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/plan_report.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/plan.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

namespace {

struct ImportFlags {
  InputFlags input;
  std::string output;
  bool plan = false;
  bool json = false;
};

Result<model::ImportOptions> parseImportFlags(const ImportFlags& flags) {
  if (!flags.plan && flags.output.empty())
    return Error{.reason = "there is no output", .remedy = "Give -o FILE.sline, or --plan"};
  if (!flags.output.empty() && !model::isSceneFile(flags.output))
    return Error{.file = flags.output,
                 .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
                 .remedy = "Name it so"};
  const Target scene{.flag = "--output", .name = flags.output, .endings = {}, .scene = true};
  if (!flags.output.empty())
    TRY(checkTargets({&scene, 1}, flags.input.inputs));
  return importOptions(flags.input);
}

Exit showPlan(const ImportFlags& flags, const model::ImportOptions& options) {
  const std::vector<std::filesystem::path> inputs(flags.input.inputs.begin(),
                                                  flags.input.inputs.end());
  Progress progress;
  const auto plan =
      model::planImport(inputs, options, [&progress](double done, const std::string& what) {
        progress.show(done, what);
        return true;
      });
  progress.wipe();
  if (!plan.ok())
    return complain(plan.error(), Exit::failed);
  std::cout << (flags.json ? jsonText(planJson(*plan), 2) + "\n" : planText(*plan));
  return Exit::done;
}

Exit runImport(const ImportFlags& flags) {
  const Result<model::ImportOptions> options = parseImportFlags(flags);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  if (flags.plan)
    return showPlan(flags, *options);
  Progress progress;
  Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  warnOfSides(imported->scene);
  for (const model::Scan& scan : imported->scene.scans())
    tell("kept with the scene: " + scan.file + ": " + model::scanText(scan));
  progress.show(0.9, "drawing the thumbnail");
  model::SceneDocument document{.scene = std::move(imported->scene),
                                .others = std::move(imported->others)};
  document.thumbnail = thumbnailOf(document.scene);
  progress.show(0.95, "writing " + flags.output);
  const Status written = model::writeSceneFile(flags.output, document);
  progress.wipe();
  return written.ok() ? Exit::done : complain(written.error(), Exit::failed);
}

void declareImport(CLI::App& command, ImportFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_option("-o,--output", flags.output, "The scene file to write")
      ->type_name("FILE.sline");
  CLI::Option* plan = command.add_flag("--plan", flags.plan,
                                       "Writes nothing: lists the tree, the frame and unit of each "
                                       "structure with what decided them, "
                                       "and what would be left out and why");
  command.add_flag("--json", flags.json, "The plan for programs: one JSON object")->needs(plan);
  command.add_option("--overlay", flags.input.overlay, overlayHelp)
      ->type_name("auto|off")
      ->default_str("auto");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  addThreshold(command, flags.input);
  command.add_flag("--keep-volume", flags.input.keepScans,
                   "Keeps scans with the scene, for slices: about as large as their packed files");
  command.add_flag(
      "--keep-file-names", flags.input.keepFileNames,
      "Keeps names of files and folders whole, and what files call their parts, points "
      "and views; else only words of anatomy and of the program, as they are often "
      "named after patients");
  command
      .add_option("--unit", flags.input.unit,
                  "How long the files' unit is, by its name or in millimetres; overrides what they "
                  "say, and says that the sizes are right")
      ->type_name("mm|cm|m|inch|um|MM");
  command
      .add_option(
          "--decimate-mm", flags.input.decimateMm,
          "Fewer triangles: as few as can be with no part of a surface farther than this "
          "from where it was, measured both ways; 0: all of them. Drawing needs triangles for "
          "its shading: about 0.05 keeps what is drawn of an organ, 0.3 little more than its "
          "outline")
      ->type_name("MM")
      ->check(within(0.0, 100.0))
      ->default_str("0");
  command.footer(
      "The scene file holds all of the scene, exactly: nothing is read from the inputs again. "
      "Every\n"
      "command takes it as an input; other inputs beside it are added below its own structures.\n\n"
      "  sline import pelvis/ --plan\n"
      "  sline import pelvis/ -o pelvis.sline --frame LPS\n"
      "  sline import pelvis/ -o small.sline --decimate-mm 0.05\n"
      "  sline import pelvis.sline tumour.stl -o together.sline\n"
      "  sline import 2src.pdb -o kinase.sline\n"
      "  sline import 4hhb.cif.gz --assembly 1 -o haemoglobin.sline\n"
      "  sline import ct.nii.gz -o ct.sline --threshold skin --threshold bone=250");
}

}  // namespace

void addImport(CLI::App& program, Exit& exit) {
  addCommand<ImportFlags>(program, exit, {"import", "Turn what can be read into a scene file"},
                          declareImport, runImport);
}

}  // namespace sline::cli
