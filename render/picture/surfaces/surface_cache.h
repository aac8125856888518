// SPDX-License-Identifier: Apache-2.0
// Keeps what is computed and uploaded once per mesh, as long as some structure shows it.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <span>

#include "model/geometry/surface.h"
#include "model/scene/scene.h"
#include "model/scene/visible_structures.h"
#include "render/drawn/gamma_offsets.h"
#include "render/drawn/prepared_surface.h"
#include "render/passes/surface_geometry.h"
#include "render/picture/surfaces/detail_levels.h"
#include "render/picture/surfaces/sample_levels.h"

namespace sline::render {

struct CachedSurface : PreparedSurface {
  SampleLevels sampleLevels;

  /// Returns the surface as the GPU has it; its vertices are `Clusters::vertices`. What is missing
  /// there is uploaded, also the curvature that fills at 3 < Γ < 4 need where `withShape` says so.
  passes::SurfaceGeometry& geometry(bool withShape);
  /// Has it keep all its triangles there.
  void keepWhole();
  /// Uploads by how much Γ differs at each vertex, unless that is what was uploaded last.
  void showGammaOffsets(const GammaOffsetsPtr& offsets);

 private:
  std::unique_ptr<passes::SurfaceGeometry> m_geometry;
  GammaOffsetsPtr m_shownOffsets;
};

class SurfaceCache {
 public:
  /// Prepares the small ones of the structures' meshes, several at a time; stops early where
  /// `unwanted` is set. Large ones wait for `at`, which takes one at a time, so that their
  /// intermediate memory is needed once.
  void prepareSmall(std::span<const model::VisibleStructure> structures,
                    const std::atomic<bool>* unwanted);
  /// Returns what is kept of the mesh, or of a level of detail, prepared; parts that exist already
  /// stay as they are.
  CachedSurface& at(const model::MeshPtr& mesh, const model::Provenance& provenance,
                    const Coarseness& allowed);
  /// Forgets all meshes but these.
  void keepOnly(std::span<const model::MeshPtr> meshes);

 private:
  std::map<model::MeshPtr, DetailLevels> m_surfaces;
};

}  // namespace sline::render
