// SPDX-License-Identifier: Apache-2.0
// Declares the sub-commands, one per file. Each adds itself to the program; its work runs once the
// command line is understood and leaves its exit code behind.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <string>
#include <utility>

#include "app/cli/files/flag_words.h"
#include "app/cli/files/names.h"
#include "app/cli/flags/scene_input.h"
#include "model/base/result.h"
#include "model/import/naming/laterality.h"

namespace sline::cli {

enum class Exit : int {
  done = 0,      ///< also when parts of a scene were left out with a warning
  failed = 1,    ///< nothing could be read, no picture could be made, or the result not be written
  wrongUse = 2,  ///< unknown flags, values out of range, names that no structure has
};

void addRender(CLI::App& program, Exit& exit);
void addAnnotate(CLI::App& program, Exit& exit);
void addDescribe(CLI::App& program, Exit& exit);
void addCredit(CLI::App& program, Exit& exit);
void addCompare(CLI::App& program, Exit& exit);
void addCompose(CLI::App& program, Exit& exit);
void addLines(CLI::App& program, Exit& exit);
void addCurvature(CLI::App& program, Exit& exit);
void addInfo(CLI::App& program, Exit& exit);
void addImport(CLI::App& program, Exit& exit);
void addPockets(CLI::App& program, Exit& exit);
void addReload(CLI::App& program, Exit& exit);
void addView(CLI::App& program, Exit& exit);
/// Receives each warning as one line.
using Warn = std::function<void(const std::string& message)>;
void addExport(CLI::App& program, Exit& exit, const Warn& tellWarning);
void addProof(CLI::App& program, Exit& exit);
void addJobs(CLI::App& program, Exit& exit);
void addDemo(CLI::App& program, Exit& exit);
/// Adds a hidden command, which draws the start page's pictures of the demos.
void addDemoPictures(CLI::App& program, Exit& exit);
void addRamp(CLI::App& program, Exit& exit);
void addSteadiness(CLI::App& program, Exit& exit);
/// Adds a hidden command, which writes man pages and completions of all commands added before.
void addManual(CLI::App& program, Exit& exit);

/// Says what went wrong on standard error and returns the exit code.
inline Exit complain(const Error& error, Exit code) {
  std::cerr << "sline: " << withFlags(onOneLine(error.text())) << '\n';
  return code;
}

/// Adds a sub-command with flags that live as long as the program: `declare(command, flags)` names
/// them, `run(flags)` does the work.
template <class Flags, class Declare, class Run>
void addCommand(CLI::App& program, Exit& exit,
                const std::pair<std::string, std::string>& nameAndHelp, const Declare& declare,
                const Run& run) {
  CLI::App* command = program.add_subcommand(nameAndHelp.first, nameAndHelp.second);
  const auto flags = std::make_shared<Flags>();
  declare(*command, *flags);
  command->callback([flags, run, &exit] { exit = run(*flags); });
}

inline constexpr const char* inputHelp =
    "Mesh files (obj, stl, ply, off, vtk, vtp, vtu, gltf, glb, 3mf), scenes of 3D programs (fbx, "
    "dae, blend, x3d, x3dv, wrl, 3ds), surfaces of brains (gii, pial, white), label volumes "
    "and scans (nii, hdr, img, mgz, nrrd, nhdr, mha, mhd, mnc), DICOM structure sets and "
    "segmentations (dcm), "
    "molecules (pdb, ent, cif, mmcif, json), many of them packed, too (stl.gz, cif.gz), folders of "
    "them, 3D Slicer scenes (mrml, mrb) and fiducials (fcsv, mrk.json), scene files (sline)";
inline constexpr const char* thresholdHelp =
    "Makes a structure of a scan (CT, MR), again for each one more: of all that is at least VALUE, "
    "or from LO to HI, in Hounsfield units where the scan has them. bone, skin and vessels have "
    "values of their own";
inline constexpr const char* frameHelp =
    "How the files' coordinates map to the patient, in place of what the files say or their names "
    "suggest: LPS, RAS, their mirror images RPS and LAS, or `file`, which leaves coordinates as "
    "they are";
inline constexpr const char* sidesHelp =
    "Settles what is not certain of left and right: `right` where they are, `mirror` where they "
    "are "
    "swapped, `turn` where front and back are swapped, too. Until then marks carry a question mark";
inline constexpr const char* verboseHelp = "Lists each surface that was repaired on reading";
inline constexpr const char* overlayHelp =
    "Several molecules: auto lays them over the first by their backbones, off leaves them";
inline constexpr const char* assemblyHelp =
    "Molecules: the biological assembly to make, by its number in the file, in place of the atoms "
    "as they stand there; its further copies of chain A are called A-2, A-3 …";
inline constexpr const char* smoothHelp =
    "auto smooths surfaces that show the steps of a label map and refines coarse ones, off leaves "
    "all as they are, a number smooths all that many times";

inline void addFrame(CLI::App& command, InputFlags& input) {
  std::string names;
  for (const model::FrameAxes& axes : model::frames)
    names += (names.empty() ? "" : "|") + std::string(axes.name);
  command.add_option("--frame", input.frame, frameHelp)->type_name(names);
  command.add_option("--sides", input.sides, sidesHelp)->type_name("right|mirror|turn");
}

/// Declares the flag that makes one scene of what is not of one patient.
inline void addTogether(CLI::App& command, InputFlags& input) {
  command.add_flag("--together", input.together,
                   "Takes files of several patients into one scene; else they are refused");
}

/// Declares the flag that reading a scan needs.
inline void addThreshold(CLI::App& command, InputFlags& input) {
  command.add_option("--threshold", input.thresholds, thresholdHelp)
      ->type_name("NAME[=VALUE|=LO..HI]")
      ->take_all()
      ->type_size(1)
      ->expected(1)
      ->allow_extra_args(false);
}

}  // namespace sline::cli
