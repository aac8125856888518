// SPDX-License-Identifier: Apache-2.0
// Turns files and folders into a scene: reads, decides frame and unit, repairs, smooths, groups and
// colours by anatomical name. Every decision is reported.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/disk/zip_archive.h"
#include "model/edit/sides.h"
#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Says how several molecules are placed: `automatic` lays all over the first where nothing but
/// molecules is imported; `off` leaves each where its file has it.
enum class Overlay { automatic, off };

/// Says what happens where files of several patients come together: `one` refuses them, `first`
/// leaves out what is of another patient than the first, `together` makes one scene of them.
enum class PatientsWanted { one, first, together };

struct ImportOptions {
  std::optional<Frame> frame;  ///< overrides header and vote
  std::optional<float> unit;   ///< millimetres per unit: overrides the files' units and guesses
                               ///< from size
  Smoothing smoothing;
  bool repair = true;
  float decimateMm = 0.0f;  ///< > 0: fewer triangles, no part of a surface moved by more than this
  Overlay overlay = Overlay::automatic;
  std::string assembly;  ///< for molecules, as ReadOptions::assembly
  ReadLimits limits;
  /// Limits the surfaces of all files together with what is made of them (disk/memory_budget.h); 0
  /// means the memory that is available.
  std::uint64_t memoryBytes = 0;
  std::vector<Threshold> thresholds = {};  ///< structures that are made of scans
  bool keepScans = false;                  ///< scans become part of the scene (Scene::scans)
  PatientsWanted patients = PatientsWanted::one;
  /// Files' and folders' names, and what files call their parts, points and views, become names in
  /// the scene whatever their words; else only what may be shown to others does
  /// (model/anatomy/shown_names.h).
  bool keepFileNames = false;
  /// The open scene that what is read is to be put into; null for none. Frames are decided and
  /// patients compared as if it had come with the files.
  std::shared_ptr<const Scene> into = nullptr;
};

/// Is called from any thread with done in [0, 1]; returns false to cancel.
using ImportProgress = std::function<bool(float done, const std::string& what)>;

/// Describes the surfaces that were repaired without loss; all members are empty where none was.
struct RepairNotes {
  std::string summary;                ///< "repaired 31 of 94 surfaces: …"
  std::vector<std::string> surfaces;  ///< a line each: "liver.obj: \"liver\": 2 faces given twice"
};

/// Says that the unit of files makes what is named larger or smaller than such structures are. It
/// was left as it is: only a person knows.
struct UnitDoubt {
  std::string file;               ///< the one that is meant; empty: all of a source
  std::size_t named = 0;          ///< structures whose names tell a size
  std::size_t fitting = 0;        ///< those of them that have such a size
  std::size_t fittingThen = 0;    ///< and how many would, with one of `units`
  float unit = 1.0f;              ///< millimetres per unit, as they were taken
  std::vector<float> units = {};  ///< millimetres per unit that would fit, the likeliest first
  std::string name = {};          ///< an example of what does not fit
  float extent = 0.0f;            ///< its size, mm
  Limits<float> expected = {};    ///< and what such structures have
  std::string stated = {};        ///< what states the unit, where it is beyond doubt

  /// Returns it in a sentence.
  std::string text() const;
};

struct ImportReport {
  Frame frame = Frame::lps;  ///< for inputs that had no header of their own
  std::string frameReason;   ///< "header", "vote: 20 of 22 left/right names", …
  std::vector<ImportWarning> warnings;
  std::vector<std::string> notes;  ///< actions without loss: molecules laid over each other,
                                   ///< assemblies that they describe
  RepairNotes repairs;
  std::vector<UnitDoubt> unitDoubts;  ///< told among the warnings, too
  /// How to read what was assumed of the scene that this goes into; done for scene files.
  std::optional<FrameAnew> frameAnew;
};

struct Imported {
  Scene scene;
  ImportReport report;
  std::vector<ZipMember> others;  ///< from scene files, as SceneDocument::others
};

/// Reads mesh files, folders of them, 3D Slicer scenes and scene files of this program into one
/// scene. Parts that cannot be read are left out with a warning; it is an error only where nothing
/// at all could be read, or a scene file could not. Scene files keep their styles, views and
/// sections and are neither turned nor smoothed; anything imported with them is added below them.
Result<Imported> importInputs(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress = {});

}  // namespace sline::model
