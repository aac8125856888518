// SPDX-License-Identifier: Apache-2.0
// Turns parts as their files have them into meshes in the scene: smoothed, in place, with fewer
// triangles.
#pragma once

#include <functional>
#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/progress_meter.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Smooths and refines each part by the grid it shares with the parts of its source, as `smoothing`
/// or its own choice asks.
void smoothParts(std::vector<Part>& parts, const Sources& sources, const Smoothing& smoothing,
                 ProgressMeter& meter);

/// Maps file coordinates → millimetres LPS, by the frame and unit in `as`.
glm::vec3 placed(const glm::vec3& p, const Provenance& as, const RawMesh& raw,
                 const std::optional<glm::dmat4>& toWorld);
/// Returns what a scene around the part's file does to it, if anything.
std::optional<glm::dmat4> toWorldOf(const Part& part, const Sources& sources);

/// Returns the surface in millimetres LPS, by the frame, unit and transform in `as`. Its
/// displacement is scaled with it.
Result<MeshPtr> placedMesh(RawMesh raw, Provenance& as);
/// Returns what the surface, or the voxels that its reader made it of, measure in millimetres,
/// placed like that; nothing where its reader smoothed it and tells no voxels.
std::optional<ReadExtent> extentAsRead(const RawMesh& raw, const Provenance& as);
/// Returns the atoms that it keeps in the same frame.
KeptAtoms placedAtoms(const RawMesh& raw, const Provenance& as);

/// Brings each part to millimetres LPS by its frame, unit and transform, and makes its mesh.
void placeParts(std::vector<Part>& parts, const Sources& sources,
                std::vector<ImportWarning>& warnings);

/// Reduces the triangles within `bound` mm or the part's own bound (meshing/simplification.h); 0
/// keeps all of them.
void decimateParts(std::vector<Part>& parts, float bound, ProgressMeter& meter);

/// Takes triangles from the mesh without moving it farther than `bound` mm and records that in the
/// provenance; returns the mesh itself where none could go. `goesOn` may end the work early.
MeshPtr decimated(const MeshPtr& mesh, float bound, Provenance& as,
                  const std::function<bool()>& goesOn);

}  // namespace sline::model
