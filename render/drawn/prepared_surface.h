// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "model/geometry/surface.h"
#include "model/scene/scene.h"
#include "render/drawn/gamma_offsets.h"
#include "render/drawn/line_scale.h"
#include "render/lines/hatching/stroke_layout.h"
#include "render/lines/techniques/line_preparations.h"

namespace sline::render {

/// Returns the mesh of the surface that pictures show: without the steps of slices (METHOD §11.7).
model::MeshPtr pictureMesh(const model::MeshPtr& mesh, const model::Provenance& provenance);
/// Returns the surface as pictures show it. Its curvature is also smoothed (METHOD §5) if import
/// smoothed the surface, because it shows the steps of a label map, or refined it, because its few
/// vertices carry its noise.
model::SurfacePtr pictureSurface(const model::MeshPtr& mesh, const model::Provenance& provenance);

/// Returns how the curvature of that surface is found.
model::CurvatureOptions pictureCurvature(const model::Provenance& provenance);

/// Says which lines a surface is to be ready for.
struct LineNeeds {
  LineKinds kinds{};
  bool hatching = false;
};

/// Holds a surface with what its strokes need, made once per mesh.
struct PreparedSurface {
  model::SurfacePtr surface;
  std::unique_ptr<StrokeLayout> strokes;  ///< null until some hatching needs it
  /// The deviation of the Gaussian by which its forms are known to be without smaller ones, mm.
  float smoothness = 0.0f;
  LineScales scales;
  LinePreparations lines;
  GammaFields gammaFields;

  /// Sets the surface and what is known of it.
  void take(const model::MeshPtr& mesh, const model::Provenance& provenance);
  /// Does so with a mesh that `pictureMesh` returned, ...
  void takeShown(const model::MeshPtr& shown, const model::Provenance& provenance);
  /// ... and with a coarser one's surface, which stands for that mesh.
  void takeCoarser(model::SurfacePtr coarser, model::FinerMesh finest,
                   const model::Provenance& provenance);

  /// Prepares the surface for these lines, once each.
  void need(const LineNeeds& needs);
};

}  // namespace sline::render
