// SPDX-License-Identifier: Apache-2.0
// Is the way from silhouette to shaded surface seamless (METHOD §7), and its tone (§6.9)? A ramp is
// the pictures of one structure alone at Γ = 0, 0.05, … 5, on white.
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

/// No step may exceed this many times the mean of its stage.
inline constexpr double jumpLimit = 3.0;
/// Over every 0.1 of Γ the picture changes at this share of its stage's mean rate, or more.
inline constexpr double deadLimit = 0.2;
/// Stages whose steps add up to less are exempt from both.
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

/// The Γ of a picture of the ramp: index / 20.
inline Gamma rampGamma(int index) {
  return Gamma::clamped(float(index) / float(stepsPerStage));
}

/// Where the pictures come from. All have one size.
struct RampPictures {
  /// The structure alone on white.
  std::function<Result<Image>(Gamma)> whole;
  /// Its fill alone on nothing; alpha is the fill's opacity.
  std::function<Result<Image>(Gamma)> fill;
};

/// One unit interval of Γ. A step's change d is the mean absolute difference of neighbouring
/// pictures over the structure's rectangle (`meanDifference`).
struct RampStage {
  double mean = 0.0;       ///< of its 20 steps' d
  double largest = 0.0;    ///< times the mean; 0 where nothing changes
  double largestAt = 0.0;  ///< Γ where that step starts
  /// Of all stretches of two steps (0.1 of Γ) within the stage the one that changes least: its mean
  /// d as a share of the stage's mean.
  double weakest = 0.0;
  double weakestAt = 0.0;    ///< Γ where it starts
  double whole = 0.0;        ///< sum of its d
  double endToEnd = 0.0;     ///< d of its last picture and its first: less than `whole` where what
                             ///< came went again
  std::vector<double> dead;  ///< Γ where each stretch below the limit starts
  /// Share of the stage's parameter T at which 10 %, 20 %, … 90 % of its change is done: for an
  /// even rate 0.1, 0.2, … 0.9.
  std::array<double, 9> timing{};

  bool exempt() const { return whole < exemptChange; }
  bool jumps() const { return !exempt() && largest > jumpLimit; }
  bool stalls() const { return !exempt() && !dead.empty(); }
};

/// What rises and falls again: the largest value v_j of a series with min(v_j − v_i, v_j − v_k) for
/// some i < j < k, at least how much it stands above both sides.
struct Bump {
  double height = 0.0;
  int at = 0;  ///< j
};

struct RampTone {
  std::vector<double> luminance;  ///< of the structure's pixels on average, for each picture
  double lowest = 0.0;            ///< of all, times the luminance at Γ = 5
  double lowestAt = 5.0;          ///< its Γ
  Bump bump;                      ///< height as a share of the luminance at Γ = 5
  /// Share of the structure's pixels whose luminance, blurred over 8 λ so that strokes become tone,
  /// rises and falls again by more than the limit; and of these, how many are lightest in each
  /// stage when first they do, as shares of all pixels too.
  double bumpedPixels = 0.0;
  std::array<double, rampStages> bumpedByStage{};

  double atEnd() const { return luminance.back(); }
  bool tooDark() const { return lowest < 1.0 - toneLimit; }
  bool turnsBack() const { return bump.height > toneLimit; }
};

struct RampFill {
  double largestFall = 0.0;   ///< of any pixel's opacity from any picture to a later one
  double fallAt = 0.0;        ///< Γ of the later one
  double fallenPixels = 0.0;  ///< share of the rectangle's pixels that fall by more than the limit
  double openAtEnd = 0.0;     ///< share of pixels inside (two off its edges) not complete at Γ = 5

  bool falls() const { return largestFall > fillFallLimit; }
  bool incomplete() const { return openAtEnd > openLimit; }
};

struct Ramp {
  PixelRect area;             ///< the structure's rectangle, rows from the top
  std::size_t pixels = 0;     ///< of it that the structure covers (half or more) at Γ = 5
  std::vector<double> steps;  ///< d from each picture to the next
  std::array<RampStage, rampStages> stages;
  RampTone tone;
  RampFill fill;
};

/// `steps` are the stage's own, `first` its first Γ.
RampStage measureStage(std::span<const double> steps, double first, double endToEnd);
Bump largestBump(std::span<const double> series);

/// Draws and measures all pictures. The error is the pictures' own, or says that the structure
/// covers no pixel.
Result<Ramp> measureRamp(const RampPictures& pictures);

/// Which rules the ramp breaks, a sentence each: "1–2: …". Empty: it is seamless.
std::vector<std::string> faults(const Ramp& ramp);

}  // namespace sline::render
