// SPDX-License-Identifier: Apache-2.0
// Implements `sline demo`: gives the scenes that the program models itself, as a list, a picture, a
// scene file or a folder of meshes.
#include <algorithm>
#include <filesystem>

#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/files/mesh_folder.h"
#include "app/cli/files/scene_summary.h"
#include "app/cli/files/targets.h"
#include "app/cli/files/thumbnail.h"
#include "app/cli/flags/picture_options.h"
#include "model/demo/demo.h"
#include "model/disk/cache_folder.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

namespace {
constexpr const char* firstView = "Overview";

struct DemoFlags {
  std::string scene = "pelvis";
  std::string sex = "female";
  bool json = false;
  PictureFlags picture{.view = firstView};
};

model::Scene sceneFor(const DemoFlags& flags) {
  const model::Sex sex = flags.sex == "male" ? model::Sex::male : model::Sex::female;
  return model::demo(*model::demoNamed(flags.scene), sex, model::userCacheFolder());
}

bool isFolderName(const std::string& output) {
  return !std::filesystem::path(output).has_extension();
}

/// Tells whether the flags say how to draw. Meshes have no style, so that this would be lost.
bool saysHowToDraw(const PictureFlags& flags) {
  return !flags.gammas.empty() || !flags.styles.empty() || !flags.lineThresholds.empty() ||
         !flags.colours.empty() || !flags.inkColours.empty() || !flags.only.empty() ||
         !flags.fill.empty() || !flags.cameraFile.empty() || !flags.drawing.empty() ||
         flags.view != firstView;
}

Exit list(const DemoFlags& flags) {
  const SceneSummary summary = summaryOf(sceneFor(flags));
  if (flags.json)
    std::cout << jsonText(summaryJson(summary), 2) << '\n';
  else
    printSummary(summary);
  return Exit::done;
}

Exit writeMeshes(const DemoFlags& flags) {
  const bool folder = isFolderName(flags.picture.output);
  if (saysHowToDraw(flags.picture))
    return complain({.file = flags.picture.output,
                     .reason = folder ? "a folder of meshes has no style and no view"
                                      : "a scene file gets the demo's own styles and views",
                     .remedy = "Name a picture (png, tiff, exr or jpg), or leave those flags out"},
                    Exit::wrongUse);
  const model::Scene scene = sceneFor(flags);
  const Status written =
      folder ? writeMeshFolder(scene, flags.picture.output)
             : model::writeSceneFile(flags.picture.output,
                                     {.scene = scene, .thumbnail = thumbnailOf(scene)});
  return written.ok() ? Exit::done : complain(written.error(), Exit::failed);
}

Exit draw(const DemoFlags& flags) {
  Result<PictureSpec> spec = parseFlags(flags.picture);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  const Target picture{.flag = "--output", .name = flags.picture.output, .endings = {}};
  if (const Status fine = checkTargets({&picture, 1}, {&flags.picture.cameraFile, 1}); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  Progress progress;
  progress.show(0.0, "modelling");
  const model::Scene scene = sceneFor(flags);
  const auto& views = scene.views();
  if (spec->view == firstView && std::none_of(views.begin(), views.end(), [](const auto& view) {
        return view.name == firstView;
      }))
    spec->view = "anterior";
  return drawScene(scene, *spec, progress);
}

Exit runDemo(const DemoFlags& flags) {
  if (flags.picture.output.empty())
    return list(flags);
  const std::string& output = flags.picture.output;
  return isFolderName(output) || model::isSceneFile(output) ? writeMeshes(flags) : draw(flags);
}

void declareDemo(CLI::App& command, DemoFlags& flags) {
  command
      .add_option("SCENE", flags.scene,
                  "kidney: a left kidney with its artery, vein and ureter; pelvis: bones, muscles, "
                  "organs, vessels, nerves and a tumour of the rectum; abdomen: the organs before "
                  "the lumbar column and their vessels. No patient's: modelled")
      ->check(CLI::IsMember({"kidney", "pelvis", "abdomen"}))
      ->capture_default_str();
  command.add_option("--sex", flags.sex, "Whose anatomy, where the scene tells them apart")
      ->check(CLI::IsMember({"female", "male"}))
      ->capture_default_str();
  CLI::Option* output = command.add_option(
      "-o,--output", flags.picture.output,
      "A picture (png, tiff, exr or jpg by its extension) or a scene file (sline); without "
      "extension a folder, new or empty, for one mesh per structure. Without -o the structures are "
      "listed");
  output->type_name("FILE|FOLDER");
  command.add_flag("--json", flags.json, "The list for programs: one JSON object")
      ->excludes(output);
  const std::vector<CLI::Option*> before = command.get_options();
  addDrawingOptions(command, flags.picture);
  for (CLI::Option* option : command.get_options())
    if (std::find(before.begin(), before.end(), option) == before.end())
      option->needs(output);
  command.footer(
      "The scene is modelled once, in some seconds, and then kept in the user's cache folder.\n\n"
      "  sline demo abdomen\n"
      "  sline demo abdomen -o abdomen.png --size 1600x1600\n"
      "  sline demo abdomen --sex male -o meshes && sline render meshes -o liver.png --only liver");
}

}  // namespace

void addDemo(CLI::App& program, Exit& exit) {
  addCommand<DemoFlags>(program, exit,
                        {"demo", "List, draw or write a scene modelled by the program"},
                        declareDemo, runDemo);
}

}  // namespace sline::cli
