// SPDX-License-Identifier: Apache-2.0
// Implements `sline reload`: reads a scene file's meshes anew from the files they came from.
#include <algorithm>

#include "app/cli/commands/command.h"
#include "app/cli/files/thumbnail.h"
#include "model/import/plan/reload.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

namespace {

struct ReloadFlags {
  std::string scene;
  std::vector<std::string> from;
  std::string output;
  bool dryRun = false;
  bool together = false;
};

const char* fateText(model::ReloadedFile::Fate fate, bool dryRun) {
  switch (fate) {
    case model::ReloadedFile::Fate::replaced:
      return dryRun ? "would be replaced" : "replaced";
    case model::ReloadedFile::Fate::unchanged:
      return "unchanged";
    case model::ReloadedFile::Fate::absent:
      return "not found";
    default:
      return "stays as it is";
  }
}

void report(const model::Reloaded& reloaded, bool dryRun) {
  for (const model::ReloadedFile& file : reloaded.files) {
    std::cout << file.file << ": " << fateText(file.fate, dryRun);
    if (!file.reason.empty())
      std::cout << " (" << file.reason << ')';
    std::string names;
    for (const model::NodeId id : file.structures)
      names += (names.empty() ? ": " : ", ") + reloaded.scene.find(id)->name;
    std::cout << names << '\n';
  }
  if (reloaded.files.empty())
    std::cout << "no structure of the scene says which file it came from\n";
  for (const model::ImportWarning& warning : reloaded.warnings)
    warn(warning.file + ": " + warning.reason);
}

bool anyStays(const model::Reloaded& reloaded) {
  return std::any_of(reloaded.files.begin(), reloaded.files.end(), [](const auto& file) {
    return file.fate == model::ReloadedFile::Fate::failed ||
           file.fate == model::ReloadedFile::Fate::absent;
  });
}

/// Reads, reloads and writes; the file written to is locked all the while.
Exit reloadInto(const ReloadFlags& flags, const model::FileLock* lock) {
  Result<model::SceneDocument> document = openedScene(flags.scene);
  if (!document.ok())
    return complain(document.error(), Exit::failed);
  std::vector<std::filesystem::path> places(flags.from.begin(), flags.from.end());
  if (places.empty())
    places.push_back(std::filesystem::absolute(flags.scene).parent_path());
  model::Reloaded reloaded =
      model::reload(document->scene, places, {},
                    flags.together ? model::PatientsWanted::together : model::PatientsWanted::one);
  report(reloaded, flags.dryRun);
  if (lock && (reloaded.changed || !flags.output.empty())) {
    document->scene = std::move(reloaded.scene);
    if (reloaded.changed)
      document->thumbnail = thumbnailOf(document->scene);
    if (const Status written = model::writeSceneFile(*lock, *document); !written.ok())
      return complain(written.error(), Exit::failed);
  }
  return anyStays(reloaded) ? Exit::failed : Exit::done;
}

Exit runReload(const ReloadFlags& flags) {
  for (const std::string& file : {flags.scene, flags.output})
    if (!file.empty() && !model::isSceneFile(file))
      return complain(
          {.file = file,
           .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
           .remedy = "Name a scene file; `sline import` makes one"},
          Exit::wrongUse);
  if (flags.dryRun)
    return reloadInto(flags, nullptr);
  const auto lock = model::FileLock::acquire(flags.output.empty() ? flags.scene : flags.output);
  if (!lock.ok())
    return complain(lock.error(), Exit::failed);
  return reloadInto(flags, &*lock);
}

void declareReload(CLI::App& command, ReloadFlags& flags) {
  command.add_option("SCENE", flags.scene, "A scene file (sline)")->required();
  command
      .add_option("--from", flags.from,
                  "A folder, searched with all below it, or a file; may be given again. Else the "
                  "folder of the scene")
      ->type_name("FOLDER")
      ->take_all()
      ->type_size(1)
      ->expected(1);
  CLI::Option* output =
      command.add_option("-o,--output", flags.output, "Writes there and leaves SCENE as it is");
  output->type_name("FILE.sline");
  command.add_flag("--dry-run", flags.dryRun, "Tells what would be done and writes nothing")
      ->excludes(output);
  command.add_flag("--together", flags.together,
                   "Reads a file that has become another patient's than the others, too");
  command.footer(
      "A file is found by its name and known by its length and checksum. One that has changed is\n"
      "read again, in the frame and unit and with the smoothing it was imported with; names, "
      "styles,\n"
      "views and sections stay, annotations go to the nearest point of the new surface. What is\n"
      "not found or cannot be read stays as it is in the scene, and the exit code is 1.\n\n"
      "  sline reload pelvis.sline --from segmentation/ --dry-run");
}

}  // namespace

void addReload(CLI::App& program, Exit& exit) {
  addCommand<ReloadFlags>(program, exit,
                          {"reload", "Read a scene file's meshes again where they have changed"},
                          declareReload, runReload);
}

}  // namespace sline::cli
