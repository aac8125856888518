// SPDX-License-Identifier: Apache-2.0
// Reads the files of a scene's structures again where they have changed since.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/import/plan/import.h"

namespace sline::model {

/// Describes the fate of a file, or of one of its surfaces.
struct ReloadedFile {
  enum class Fate {
    replaced,   ///< it has changed; the structures have its surfaces now
    unchanged,  ///< it has not changed
    absent,     ///< no file of the name was found
    failed      ///< structures stay as they are; `reason` tells why
  };
  std::string file;
  Fate fate = Fate::unchanged;
  std::string reason;
  std::vector<NodeId> structures;
  bool operator==(const ReloadedFile&) const = default;
};

/// Describes a mesh that replaces the one a structure had.
struct NewMesh {
  NodeId structure;
  MeshPtr before;
  MeshPtr mesh;
  Provenance provenance;
  PaintPtr paintBefore;
  PaintPtr paint;  ///< what was painted before, on the new mesh
};

struct Reloaded {
  Scene scene;
  bool changed = false;
  std::vector<NewMesh> meshes;      ///< the meshes of `scene` that are new
  std::vector<ReloadedFile> files;  ///< by name
  std::vector<ImportWarning> warnings;
};

/// Looks for each structure's file (Provenance::file) in the places, which are files or folders
/// with all below them, and reads it again where its fingerprint differs: in the same frame and
/// unit, with as many steps of smoothing and refinement, and decimated as far as before. Ids,
/// names, styles, sections and views stay; annotations on a surface go to the nearest point of the
/// new one, and so does what was painted; a warning says where much of that is lost. Of a file with
/// several surfaces each structure takes the one of its name. Where several files have the name,
/// one that is unchanged counts, with the others as its `reason`; else it is an error, as it is not
/// known which is meant. What is far larger or smaller than before has a doubted unit. A file
/// that has become another patient's than the others is not read, unless they are wanted together.
Reloaded reload(const Scene& scene, std::span<const std::filesystem::path> places,
                const ReadOptions& options = {}, PatientsWanted patients = PatientsWanted::one);

/// Puts the new meshes into a scene that was edited meanwhile; structures that no longer have the
/// mesh `before` stay as they are.
Scene withNewMeshes(const Scene& scene, std::span<const NewMesh> meshes);

}  // namespace sline::model
