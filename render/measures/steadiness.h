// SPDX-License-Identifier: Apache-2.0
// Measures whether hatching stays on the surface while the camera turns (METHOD §6.10) and whether
// a stroke has a definite edge (§6.8).
//
// The second question is asked of print. An edge is as soft as a pixel, so every pixel in it is a
// mid-tone, and on a screen a stroke one or two pixels wide is nearly all edge: no method of
// hatching that takes part in anti-aliasing could keep METHOD's limit there, and one that does
// without it crawls. Strokes that smear to grey, which §6.8 forbids, do not go away with size; the
// edge does. So the share of mid-tones is reported at the picture's own size, and its limit holds
// at the size of a plate.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/camera/camera.h"
#include "model/geometry/mesh.h"
#include "render/raster/image.h"

namespace sline::render {

/// For the same amount of ink, strokes may change at most this share of what hatching as printed
/// changes. ▲ It is not simply the share of the change: a method that draws less changes less, so
/// blank paper would win, and hatching as printed leaves blank the convex forms that strokes model.
inline constexpr double flickerLimit = 0.5;
/// At most this share of the pixels with ink in print may be neither light nor dark.
inline constexpr double midToneLimit = 0.25;
/// The rows of a plate in print: 183 mm, the width of a journal's page, at 300 dots per inch.
inline constexpr int printHeight = 2160;
/// A pixel counts as hatched where its ink is more than this.
inline constexpr float leastInk = 0.02f;
/// Ink between these two values is a mid-tone.
inline constexpr float lightestMidTone = 0.2f;
inline constexpr float darkestMidTone = 0.8f;
/// The degrees between one picture and the next.
inline constexpr float turnStep = 0.5f;

/// Draws hatching alone, black on white, from that camera at that size; a larger picture is the
/// same drawing, finer.
using HatchingPicture = std::function<Result<Image>(const model::Camera&, int width, int height)>;

struct HatchingWay {
  HatchingPicture draw;
  /// Pictures are drawn this many times as large and compared in pixels of the requested size, as
  /// no interpolation knows where within a pixel the edge of a stroke lies: strokes a pixel wide
  /// that move sideways with the surface seem to change by 0.17 of what they could; drawn three
  /// times as large, by 0.06. This suits a method that draws the same at any size, only finer. A
  /// method that searches pixel by pixel draws something else in a larger picture, and is looked at
  /// as it is.
  int oversampling = 1;
};

struct PictureSize {
  int width = 0;
  int height = 0;
  bool operator==(const PictureSize&) const = default;
};

/// Describes a mesh that turns in front of a camera.
struct Turntable {
  model::MeshPtr mesh;
  model::Camera camera;  ///< that of the first picture
  int width = 0;
  int height = 0;
  int frames = 10;                        ///< how many pairs of pictures are compared
  int printHeight = render::printHeight;  ///< at which the edges of strokes are looked at
};

/// Returns the size of the same picture in print: less than `printHeight` high where it would be
/// wider than 20 000.
PictureSize printSize(const Turntable& turntable);

/// Returns the camera turned about the picture's vertical through the point, to the right as the
/// camera sees it.
model::Camera turned(const model::Camera& camera, const glm::vec3& middle, float degrees);

struct Flicker {
  /// Mean absolute difference of ink between a picture and the one before it, warped to it by depth
  /// and camera: over the surface that both see, and over those of its pixels that are hatched in
  /// either.
  double overSurface = 0.0;
  double overHatching = 0.0;
  double hatchedShare = 0.0;  ///< of the surface that both pictures show
  double ink = 0.0;           ///< mean over that surface and both pictures
  /// Share of mid-tones among the hatched pixels of the first picture, at its own size and in
  /// print.
  double midTones = 0.0;
  double midTonesInPrint = 0.0;

  bool anyHatching() const { return hatchedShare > 0.0; }
};

/// Returns one result for each way of hatching. The error is that of a picture, or says that two
/// pictures share no surface.
Result<std::vector<Flicker>> measureFlicker(const Turntable& turntable,
                                            std::span<const HatchingWay> ways);

/// Returns the share of pixels with ink between the bounds of mid-tones among those with any ink; 0
/// where there is no ink.
double midToneShare(const Image& image);

struct Steadiness {
  Flicker strokes;
  Flicker asPrinted;

  /// Returns the strokes' flicker over the surface as a share of that of hatching as printed;
  /// nothing where either shows no hatching. This is METHOD §6.10's figure to the letter; see
  /// `flickerLimit`.
  std::optional<double> ratio() const;
  /// Returns the same share over hatched pixels.
  std::optional<double> hatchedRatio() const;
  /// Returns what `ratio` returns, but for the same amount of ink.
  std::optional<double> inkRatio() const;
};

/// Returns a sentence for each rule that is broken.
std::vector<std::string> faults(const Steadiness& steadiness);

}  // namespace sline::render
