// SPDX-License-Identifier: Apache-2.0
// Does hatching stay on the surface while the camera turns (METHOD §6.10), and has a stroke a
// definite edge (§6.8)?
//
// The second is asked of print. An edge is as soft as a pixel, whatever lies in it is a mid-tone,
// and on a screen a stroke one or two pixels wide is nearly all edge: no method of hatching that
// takes part in anti-aliasing could keep METHOD's limit there, and one that does without it crawls.
// What §6.8 forbids, strokes that smear to grey, does not go away with size; the edge does. So the
// share of mid-tones is told at the picture's own size, and its limit holds at the size of a plate.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/geometry/mesh.h"
#include "model/scene/camera.h"
#include "render/raster/image.h"

namespace sline::render {

/// For as much ink strokes may change at most this share of what hatching as printed changes. ▲ Not
/// simply of its change: who draws less changes less, so blank paper would win, and hatching as
/// printed leaves convex forms blank that strokes model.
inline constexpr double flickerLimit = 0.5;
/// Of the pixels with ink in print at most this share may be neither light nor dark.
inline constexpr double midToneLimit = 0.25;
/// Rows of a plate in print: 183 mm, the width of a journal's page, at 300 dots to an inch.
inline constexpr int printHeight = 2160;
/// A pixel is hatched where its ink is more than this.
inline constexpr float leastInk = 0.02f;
/// Ink between these is a mid-tone.
inline constexpr float lightestMidTone = 0.2f;
inline constexpr float darkestMidTone = 0.8f;
/// Degrees between one picture and the next.
inline constexpr float turnStep = 0.5f;

/// Hatching alone, black on white, from that camera at that size: a larger picture is the same
/// drawing, finer.
using HatchingPicture = std::function<Result<Image>(const model::Camera&, int width, int height)>;

struct HatchingWay {
  HatchingPicture draw;
  /// Pictures are drawn this many times as large and compared in pixels of the size asked for. No
  /// interpolation knows where within a pixel the edge of a stroke lies: strokes a pixel wide that
  /// move across themselves with the surface seem to change by 0.17 of what they could; drawn three
  /// times as large by 0.06. For a way that draws the same at any size, only finer. One that
  /// searches pixel by pixel draws something else in a larger picture, and is looked at as it is.
  int oversampling = 1;
};

struct PictureSize {
  int width = 0;
  int height = 0;
  bool operator==(const PictureSize&) const = default;
};

/// What is turned before which camera.
struct Turntable {
  model::MeshPtr mesh;
  model::Camera camera;  ///< of the first picture
  int width = 0;
  int height = 0;
  int frames = 10;                        ///< pairs of pictures that are compared
  int printHeight = render::printHeight;  ///< at which the edges of strokes are looked at
};

/// The size of the same picture in print: less than `printHeight` high where it would be wider than
/// 20 000.
PictureSize printSize(const Turntable& turntable);

/// The camera turned about the picture's vertical through the point, to the right of what it sees.
model::Camera turned(const model::Camera& camera, const glm::vec3& middle, float degrees);

struct Flicker {
  /// Mean absolute difference of ink between a picture and the one before it, warped to it by depth
  /// and camera: over the surface that both see, and over those of its pixels that are hatched in
  /// either.
  double overSurface = 0.0;
  double overHatching = 0.0;
  double hatchedShare = 0.0;  ///< of the surface seen in both
  double ink = 0.0;           ///< mean over it and over both pictures
  /// Share of mid-tones among hatched pixels of the first picture, and of the same in print.
  double midTones = 0.0;
  double midTonesInPrint = 0.0;

  bool anyHatching() const { return hatchedShare > 0.0; }
};

/// One result for each way of hatching. The error is a picture's own, or says that two pictures
/// share no surface.
Result<std::vector<Flicker>> measureFlicker(const Turntable& turntable,
                                            std::span<const HatchingWay> ways);

/// Share of pixels with ink between the bounds of mid-tones among those with ink at all; 0 where
/// there is none.
double midToneShare(const Image& image);

struct Steadiness {
  Flicker strokes;
  Flicker asPrinted;

  /// Strokes' flicker over the surface as a share of that of hatching as printed; none where either
  /// shows no hatching. This is METHOD §6.10's figure to the letter; see `flickerLimit`.
  std::optional<double> ratio() const;
  /// The same over hatched pixels.
  std::optional<double> hatchedRatio() const;
  /// The same as the first for as much ink.
  std::optional<double> inkRatio() const;
};

/// Which rules are broken, a sentence each.
std::vector<std::string> faults(const Steadiness& steadiness);

}  // namespace sline::render
