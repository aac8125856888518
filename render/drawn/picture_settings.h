// SPDX-License-Identifier: Apache-2.0
// Describes how a picture is drawn, besides what the scene says.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/raster/image.h"

namespace sline::render {

enum class Background { white, paper, dark, transparent };

/// Describes what surrounds the anatomy: what lies behind it and where its light comes from.
struct Environment {
  Background background = Background::white;
  /// Points towards the light that hatching's shadows turn away from, in the camera's frame (right,
  /// up, back); absent: the scene's own, else from the upper left.
  std::optional<glm::vec3> light;
  /// Shading has that light, too, besides the headlight; absent: as the scene says, else not.
  std::optional<bool> keyLight;
  bool operator==(const Environment&) const = default;
};

/// How hatching is made: strokes along curves (ours), or S §3.4 as printed, which is grey and of
/// one scale: a yardstick for measures.
enum class HatchingMethod { strokes, asPrinted };

/// Tells which parts of a picture are drawn; measures look at one part alone.
struct PictureContent {
  bool lines = true;  ///< contours, suggestive contours
  bool hatching = true;
  bool fills = true;
  bool operator==(const PictureContent&) const = default;
};

struct PictureSettings {
  int width = 1280;
  int height = 720;
  Environment environment;
  HatchingMethod hatching = HatchingMethod::strokes;
  PictureContent parts;
  /// Surfaces are drawn with one pixel for so many of the picture each way, 1 … 4, as is enough
  /// while they move; lines are as sharp as ever. Graphics cards draw as with 1.
  int surfaceStep = 1;
  /// The picture will be reduced by so much each way: surfaces need be no finer than for that.
  int samples = 1;
  /// Nothing is prepared that takes long and that a picture can do without, as while the camera
  /// moves: lines may be found at another scale of a surface (PictureTimings::makeshift).
  bool hurried = false;
};

/// Draws a picture for measures, which need not know how it is drawn.
using DrawPicture = std::function<Result<Image>(
    const model::Scene& scene, const model::Camera& camera, const PictureSettings& settings)>;

}  // namespace sline::render
