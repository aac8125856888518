// SPDX-License-Identifier: Apache-2.0
// Takes one structure of a scene by itself and draws it for measures.
#pragma once

#include <functional>

#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"
#include "render/measures/ramp.h"
#include "render/measures/steadiness.h"

namespace sline::render {

/// Holds a structure alone in a scene with the look that it has there, but neither see-through nor
/// with a wash behind its lines, and from where and at what size it is looked at.
struct Subject {
  model::Scene scene;  ///< holds the structure alone
  model::Camera camera;
  int width = 0;
  int height = 0;

  const model::Node& structure() const { return scene.nodes().front(); }
  /// Returns the scene with the structure at that Γ.
  model::Scene at(Gamma gamma) const;
};

/// Returns a scene that holds this structure alone. The node must be a structure.
model::Scene isolated(const model::Scene& scene, model::NodeId structure);

/// Returns the subject's ramp as `draw` draws it. The subject must live as long as the result; each
/// picture of the whole structure is also passed to `onPicture`, if there is one.
RampPictures rampPictures(const DrawPicture& draw, const Subject& subject,
                          std::function<void(Gamma, const Image&)> onPicture = {});

struct SteadinessSettings {
  Gamma gamma;
  int frames = 10;
  int oversampling = 4;  ///< applies to strokes
};
/// Measures the subject's hatching at the subject's size. The error names the structure.
Result<Steadiness> measureSteadiness(const DrawPicture& draw, const Subject& subject,
                                     const SteadinessSettings& settings);

/// Returns a function that draws the subject's hatching alone at that Γ, black on white, by that
/// method.
HatchingPicture hatchingPicture(const DrawPicture& draw, const Subject& subject, Gamma gamma,
                                HatchingMethod method);

}  // namespace sline::render
