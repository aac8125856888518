// SPDX-License-Identifier: Apache-2.0
// Measures whether the way from silhouette to shaded surface is seamless (METHOD §7), and its tone
// (§6.9). A ramp consists of the pictures of one structure alone at Γ = 0, 0.05, … 5, on white.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "render/raster/image.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

inline constexpr int rampStages = 5;
inline constexpr int stepsPerStage = 20;
inline constexpr int rampSteps = rampStages * stepsPerStage;

/// No step may exceed the mean of its stage by more than this factor.
inline constexpr double jumpLimit = 3.0;
/// Over every 0.1 of Γ the picture must change at least at this share of its stage's mean rate.
inline constexpr double deadLimit = 0.2;
/// Stages that have steps adding up to less than this are exempt from both limits.
inline constexpr double exemptChange = 0.002;
/// How much darker than at Γ = 5 a structure may be, and how much lighter it may become before it
/// darkens again, both as a share of its luminance at Γ = 5.
inline constexpr double toneLimit = 0.02;
/// Opacity may fall by one of 255 levels, which is rounding.
inline constexpr double fillFallLimit = 1.5 / 255.0;
/// A fill is complete at Γ = 5: inside the structure at most `openLimit` of the pixels are less
/// opaque than this. Those few are slits between its parts, narrower than a pixel.
inline constexpr double completeOpacity = 0.98;
inline constexpr double openLimit = 0.001;

/// Returns the Γ of a picture of the ramp: index / 20.
inline Gamma rampGamma(int index) {
  return Gamma::clamped(float(index) / float(stepsPerStage));
}

/// Supplies the pictures of a ramp, all of one size.
struct RampPictures {
  /// Draws the structure alone on white.
  std::function<Result<Image>(Gamma)> whole;
  /// Draws its fill alone on nothing; alpha is the fill's opacity.
  std::function<Result<Image>(Gamma)> fill;
};

/// Describes one unit interval of Γ. A step's change d is the mean absolute difference of
/// neighbouring pictures over the structure's rectangle (`meanDifference`).
struct RampStage {
  double mean = 0.0;       ///< of the d of its 20 steps
  double largest = 0.0;    ///< as a multiple of the mean; 0 where nothing changes
  double largestAt = 0.0;  ///< Γ where that step starts
  /// The smallest change over any stretch of two steps (0.1 of Γ) within the stage: the stretch's
  /// mean d as a share of the stage's mean.
  double weakest = 0.0;
  double weakestAt = 0.0;    ///< Γ where that stretch starts
  double whole = 0.0;        ///< sum of the d of its steps
  double endToEnd = 0.0;     ///< d of its last picture and its first: less than `whole`
                             ///< where a change was undone
  std::vector<double> dead;  ///< Γ where each stretch below the limit starts
  /// Share of the stage's parameter T at which 10 %, 20 %, … 90 % of its change is done: for an
  /// even rate 0.1, 0.2, … 0.9.
  std::array<double, 9> timing{};

  bool exempt() const { return whole < exemptChange; }
  bool jumps() const { return !exempt() && largest > jumpLimit; }
  bool stalls() const { return !exempt() && !dead.empty(); }
};

/// Describes a rise that falls again: the largest value v_j of a series with the height min(v_j −
/// v_i, v_j − v_k) for some i < j < k, the least by which it stands above both sides.
struct Bump {
  double height = 0.0;
  int at = 0;  ///< j
};

struct RampTone {
  std::vector<double> luminance;  ///< mean over the structure's pixels, for each picture
  double lowest = 0.0;            ///< the lowest of all, as a multiple of the luminance at Γ = 5
  double lowestAt = 5.0;          ///< Γ where it is lowest
  Bump bump;                      ///< its height is a share of the luminance at Γ = 5
  /// Share of the structure's pixels with a luminance, blurred over 8 λ so that strokes become
  /// tone, that rises and falls again by more than the limit; and how many of these are lightest in
  /// each stage when they first do so, also as shares of all pixels.
  double bumpedPixels = 0.0;
  std::array<double, rampStages> bumpedByStage{};

  double atEnd() const { return luminance.back(); }
  bool tooDark() const { return lowest < 1.0 - toneLimit; }
  bool turnsBack() const { return bump.height > toneLimit; }
};

struct RampFill {
  double largestFall = 0.0;   ///< of any pixel's opacity from any picture to a later one
  double fallAt = 0.0;        ///< Γ of the later picture
  double fallenPixels = 0.0;  ///< share of the rectangle's pixels that fall by more than the limit
  double openAtEnd = 0.0;     ///< share of pixels inside (two off its edges) not complete at Γ = 5

  bool falls() const { return largestFall > fillFallLimit; }
  bool incomplete() const { return openAtEnd > openLimit; }
};

struct Ramp {
  PixelRect area;             ///< the structure's rectangle, rows counted from the top
  std::size_t pixels = 0;     ///< pixels of it that the structure covers (half or more) at Γ = 5
  std::vector<double> steps;  ///< d from each picture to the next
  std::array<RampStage, rampStages> stages;
  RampTone tone;
  RampFill fill;
};

/// Measures a stage; `steps` are the stage's own, `first` is its first Γ.
RampStage measureStage(std::span<const double> steps, double first, double endToEnd);
Bump largestBump(std::span<const double> series);

/// Draws and measures all pictures. The error is that of a picture, or says that the structure
/// covers no pixel.
Result<Ramp> measureRamp(const RampPictures& pictures);

/// Returns a sentence for each rule that the ramp breaks: "1–2: …". Empty: it is seamless.
std::vector<std::string> faults(const Ramp& ramp);

}  // namespace sline::render
