// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/prepared_surface.h"

#include <algorithm>
#include <utility>

#include "model/fairing/faired.h"
#include "render/lines/hatching/hatching.h"

namespace sline::render {

namespace {

// Surfaces from slices have lost what is smaller than this many slices.
constexpr float fairedSlices = 2.0f;

/// Returns the one-ring averaging steps of the curvature tensor (METHOD §5). Refinement halves the
/// rings, so twice the steps make up for a part of it; four times, for the whole, were seen to wipe
/// out the folds of a coarse colon.
int tensorSmoothing(const model::Provenance& provenance) {
  constexpr int steps = 4;
  if (provenance.refinementSteps > 0)
    return steps << std::min(provenance.refinementSteps, 2);
  return provenance.smoothingSteps > 0 ? steps : 0;
}

float smoothnessOf(const model::Provenance& provenance) {
  return fairedSlices * provenance.sliceMm;
}

}  // namespace

model::MeshPtr pictureMesh(const model::MeshPtr& mesh, const model::Provenance& provenance) {
  return model::faired(mesh, provenance.sliceMm);
}

model::SurfacePtr pictureSurface(const model::MeshPtr& mesh, const model::Provenance& provenance) {
  return model::prepareSurface(pictureMesh(mesh, provenance), pictureCurvature(provenance));
}

model::CurvatureOptions pictureCurvature(const model::Provenance& provenance) {
  return {.smoothingSteps = tensorSmoothing(provenance)};
}

void PreparedSurface::take(const model::MeshPtr& mesh, const model::Provenance& provenance) {
  takeShown(pictureMesh(mesh, provenance), provenance);
}

void PreparedSurface::takeShown(const model::MeshPtr& shown, const model::Provenance& provenance) {
  surface = model::prepareSurface(shown, pictureCurvature(provenance));
  smoothness = smoothnessOf(provenance);
}

void PreparedSurface::takeCoarser(model::SurfacePtr coarser, model::FinerMesh finest,
                                  const model::Provenance& provenance) {
  surface = std::move(coarser);
  scales.smooth(std::move(finest));
  smoothness = smoothnessOf(provenance);
}

void PreparedSurface::need(const LineNeeds& needs) {
  lines.make(needs.kinds, *surface);
  if (needs.hatching && !strokes)
    strokes = std::make_unique<StrokeLayout>(surface, longestHatchStroke / hatchSpacing);
}

}  // namespace sline::render
