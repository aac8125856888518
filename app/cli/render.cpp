// SPDX-License-Identifier: Apache-2.0
// Implements `sline render`: reads files and draws a picture.
#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/picture_options.h"

namespace sline::cli {

namespace {

struct RenderFlags {
  InputFlags input;
  PictureFlags picture;
};

Exit runRender(const RenderFlags& flags) {
  const Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  const Result<PictureSpec> spec = parseFlags(flags.picture);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  std::vector<std::string> read = flags.input.inputs;
  read.push_back(flags.picture.cameraFile);
  const Target picture{.flag = "--output", .name = flags.picture.output, .endings = {}};
  if (const Status fine = checkTargets({&picture, 1}, read); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);

  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  warnOfSides(imported->scene);
  warnOfNoLabels(flags.picture.labels, imported->scene);
  return drawScene(imported->scene, *spec, progress);
}

void declareRender(CLI::App& command, RenderFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  addPictureOptions(command, flags.picture);
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
  command.footer(
      "NAME is a structure's or a group's name (`sline info` lists them); case and the difference\n"
      "between space, '_' and '-' do not matter. A group's value holds for all in it; the\n"
      "innermost name wins. --gamma and --color take several NAME=VALUE, --only several names.\n\n"
      "  sline render pelvis/ -o pelvis.png --gamma 1 --gamma bladder=4 --view anterior\n"
      "  sline render abdomen.sline -o kidney.png --focus \"left kidney\" --context 0.6\n"
      "  sline render liver.stl -o liver.tiff --size 4000x3000 --background transparent");
}

}  // namespace

void addRender(CLI::App& program, Exit& exit) {
  addCommand<RenderFlags>(program, exit, {"render", "Draw a picture of meshes, folders and scenes"},
                          declareRender, runRender);
}

}  // namespace sline::cli
