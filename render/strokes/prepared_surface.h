// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "model/geometry/surface.h"
#include "model/scene/scene.h"
#include "render/lines/stroke_layout.h"

namespace sline::render {

/// Returns the surface as pictures show it. What import smoothed, because it shows the steps of a
/// label map, or refined, because its few vertices carry its noise, has its curvature smoothed too
/// (METHOD §5).
model::SurfacePtr pictureSurface(const model::MeshPtr& mesh, const model::Provenance& provenance);

/// A surface with what its strokes need, made once per mesh.
struct PreparedSurface {
  model::SurfacePtr surface;
  std::unique_ptr<StrokeLayout> strokes;  ///< null until some hatching needs it

  /// Prepares for strokes of hatching, once.
  void needStrokes();
};

}  // namespace sline::render
