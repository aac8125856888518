// SPDX-License-Identifier: Apache-2.0
// Implements `sline pockets`: finds the pockets of proteins and lists them.
#include <cstdio>

#include "app/cli/commands/command.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/progress.h"
#include "app/cli/files/thumbnail.h"
#include "model/pockets/pocket_focus.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

namespace {

struct PocketFlags {
  InputFlags input;
  model::PocketOptions options;
  bool json = false;
  int focus = 0;  ///< a pocket's number; 0: none
  std::string output;
};

std::string guestNames(const model::Scene& scene, const model::ScenePocket& pocket) {
  std::string names;
  for (const model::NodeId id : pocket.guests)
    names += (names.empty() ? "" : ", ") + scene.find(id)->name;
  return names;
}

std::string liningText(const model::ScenePockets& found, const model::ScenePocket& pocket) {
  std::string text;
  for (const std::string& residue : found.lining(pocket))
    text += (text.empty() ? "" : ", ") + residue;
  return text;
}

void printTable(const model::Scene& scene, const model::ScenePockets& found) {
  const bool several = found.molecules.size() > 1;
  std::cout << "pocket  volume Å³  mouth Å²  burial %  holds and is lined by\n";
  for (const model::ScenePocket& pocket : found.pockets) {
    char figures[96];
    std::snprintf(figures, sizeof figures, "%6d  %9.0f  %8.0f  %8.0f  ", pocket.number,
                  pocket.pocket.volume, pocket.pocket.mouth, 100.0 * double(pocket.pocket.burial));
    std::cout << figures;
    if (several)
      std::cout << found.molecules[pocket.molecule].name << ": ";
    const std::string guests = guestNames(scene, pocket);
    std::cout << (guests.empty() ? "" : guests + "; ") << liningText(found, pocket) << '\n';
  }
  if (found.pockets.empty())
    std::cout << "no pocket of that size\n";
}

void printPocketsJson(const model::Scene& scene, const model::ScenePockets& found,
                      const model::PocketOptions& options) {
  Json root = {{"small_probe_angstrom", options.smallProbe},
               {"large_probe_angstrom", options.largeProbe},
               {"least_volume_angstrom3", options.leastVolume},
               {"molecules", Json::array()},
               {"pockets", Json::array()}};
  for (const model::PocketMolecule& molecule : found.molecules)
    root["molecules"].push_back(
        {{"name", molecule.name}, {"lattice_step_angstrom", molecule.grid.step}});
  for (const model::ScenePocket& pocket : found.pockets) {
    const glm::dvec3& c = pocket.pocket.centre;
    Json guests = Json::array();
    for (const model::NodeId id : pocket.guests)
      guests.push_back(scene.find(id)->name);
    root["pockets"].push_back({{"number", pocket.number},
                               {"molecule", pocket.molecule},
                               {"volume_angstrom3", pocket.pocket.volume},
                               {"mouth_angstrom2", pocket.pocket.mouth},
                               {"burial", pocket.pocket.burial},
                               {"centre_mm", {c.x, c.y, c.z}},
                               {"holds", std::move(guests)},
                               {"lining", found.lining(pocket)}});
  }
  std::cout << jsonText(root, 2) << '\n';
}

/// Writes the scene with the pocket of that number in focus, seen through its mouth.
Exit writeFocused(const PocketFlags& flags, const model::Scene& scene,
                  const model::ScenePockets& found) {
  const auto pocket =
      std::find_if(found.pockets.begin(), found.pockets.end(),
                   [&flags](const model::ScenePocket& each) { return each.number == flags.focus; });
  if (pocket == found.pockets.end())
    return complain({.reason = "there is no pocket " + std::to_string(flags.focus)},
                    Exit::wrongUse);
  const model::MeshPtr room =
      model::pocketBody(found.molecules[pocket->molecule].grid, pocket->pocket);
  model::SceneDocument document;
  document.scene =
      model::withPocketInFocus(scene, found, std::size_t(pocket - found.pockets.begin()), room)
          .scene;
  model::View view{.name = "Pocket " + std::to_string(flags.focus),
                   .camera = model::viewIntoPocket(*pocket, {})};
  std::vector<model::View> views = document.scene.views();
  views.push_back(std::move(view));
  document.scene.setViews(std::move(views));
  document.thumbnail = thumbnailOf(document.scene);
  if (const Status written = model::writeSceneFile(flags.output, document); !written.ok())
    return complain(written.error(), Exit::failed);
  return Exit::done;
}

Exit runPockets(const PocketFlags& flags) {
  if (const std::string fault = model::pocketOptionsFault(flags.options); !fault.empty())
    return complain({.reason = fault}, Exit::wrongUse);
  if ((flags.focus > 0) == flags.output.empty())
    return complain({.reason = "--focus and --output belong together"}, Exit::wrongUse);
  Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const Result<model::ScenePockets> found =
      model::pocketsIn(imported->scene, flags.options, [] { return true; });
  if (!found.ok())
    return complain(found.error(), Exit::failed);
  if (flags.json)
    printPocketsJson(imported->scene, *found, flags.options);
  else
    printTable(imported->scene, *found);
  return flags.focus > 0 ? writeFocused(flags, imported->scene, *found) : Exit::done;
}

void declarePockets(CLI::App& command, PocketFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  addTogether(command, flags.input);
  command.add_flag("--json", flags.json, "For programs: one JSON object on standard output");
  command
      .add_option("--probe", flags.options.smallProbe,
                  "Radius in Å of the ball that goes into pockets, 0.8 to 5 (1.4, water)")
      ->type_name("Å");
  command
      .add_option("--large-probe", flags.options.largeProbe,
                  "Radius in Å of the ball that stays out of pockets, 2 to 20 (5)")
      ->type_name("Å");
  command
      .add_option("--least-volume", flags.options.leastVolume,
                  "Leaves out pockets smaller than that many Å³, 1 to 10000 (50)")
      ->type_name("Å³");
  command
      .add_option("--step", flags.options.step,
                  "Step in Å of the lattice on which they are found, 0.25 to 1.5 (0.5)")
      ->type_name("Å");
  command
      .add_option("--focus", flags.focus,
                  "Puts the pocket of that number in focus in the scene that --output names")
      ->type_name("N");
  command.add_option("-o,--output", flags.output, "Scene file to write, with --focus")
      ->type_name("FILE.sline");
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_option("--overlay", flags.input.overlay, overlayHelp)->type_name("auto|off");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  command.footer(
      "Pockets are where the small ball fits between the atoms of the chains and the large one\n"
      "does not (Kawabata 2010), the largest first; the mouth is where they are open to it. "
      "Burial\n"
      "is the share of directions in which atoms lie within 10 Å. Several molecules are laid over\n"
      "the first; pockets that share room or residues have the same number.");
}

}  // namespace

void addPockets(CLI::App& program, Exit& exit) {
  addCommand<PocketFlags>(program, exit,
                          {"pockets", "List the pockets of proteins: volume, mouth, residues"},
                          declarePockets, runPockets);
}

}  // namespace sline::cli
