// SPDX-License-Identifier: Apache-2.0
// Does hatching stay on the surface while the camera turns (METHOD §6.10), and has a stroke a
// definite edge (§6.8)?
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/geometry/mesh.h"
#include "model/scene/camera.h"
#include "render/picture/image.h"

namespace sline::render {

/// Strokes may change at most this share of what hatching as printed changes.
inline constexpr double flickerLimit = 0.5;
/// Of the pixels with ink at most this share may be neither light nor dark.
inline constexpr double midToneLimit = 0.25;
/// A pixel is hatched where its ink is more than this.
inline constexpr float leastInk = 0.02f;
/// Ink between these is a mid-tone.
inline constexpr float lightestMidTone = 0.2f;
inline constexpr float darkestMidTone = 0.8f;
/// Degrees between one picture and the next.
inline constexpr float turnStep = 0.5f;

/// Hatching alone, black on white, from that camera at that size.
using HatchingPicture = std::function<Result<Image>(const model::Camera&, int width, int height)>;

/// What is turned before which camera.
struct Turntable {
  model::MeshPtr mesh;
  model::Camera camera;  ///< of the first picture
  int width = 0;
  int height = 0;
  int frames = 10;  ///< pairs of pictures that are compared
};

/// The camera turned about the picture's vertical through the point, to the right of what it sees.
model::Camera turned(const model::Camera& camera, const glm::vec3& middle, float degrees);

struct Flicker {
  /// Mean absolute difference of ink between a picture and the one before it, warped to it by depth
  /// and camera: over the surface that both see, and over those of its pixels that are hatched in
  /// either.
  double overSurface = 0.0;
  double overHatching = 0.0;
  double hatchedShare = 0.0;  ///< of the surface seen in both
  /// Share of mid-tones among hatched pixels of the first picture, and of one of twice its size.
  double midTones = 0.0;
  double midTonesDoubled = 0.0;

  bool anyHatching() const { return hatchedShare > 0.0; }
};

/// One result for each way of hatching. The error is a picture's own, or says that two pictures
/// share no surface.
Result<std::vector<Flicker>> measureFlicker(const Turntable& turntable,
                                            std::span<const HatchingPicture> ways);

/// Share of pixels with ink between the bounds of mid-tones among those with ink at all; 0 where
/// there is none.
double midToneShare(const Image& image);

struct Steadiness {
  Flicker strokes;
  Flicker asPrinted;

  /// Strokes' flicker over the surface as a share of that of hatching as printed; none where either
  /// shows no hatching.
  std::optional<double> ratio() const;
  /// The same over hatched pixels.
  std::optional<double> hatchedRatio() const;
};

/// Which rules are broken, a sentence each.
std::vector<std::string> faults(const Steadiness& steadiness);

}  // namespace sline::render
