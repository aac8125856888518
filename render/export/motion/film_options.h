// SPDX-License-Identifier: Apache-2.0
// Declares the options of films.
#pragma once

#include <optional>
#include <vector>

#include "render/export/order/export_option.h"

namespace sline::render {

/// Tells what moves in a film: the camera once around the scene; the camera from saved view to
/// saved view; Γ from 0 to 5.
enum class Motion { turntable, tour, gammaSweep };

/// Tells how large a film's pictures are. `typed`: as many pixels as were typed each way; `page`:
/// of the page's shape, and as high as was typed.
enum class FilmFormat { hd, fullHd, square, typed, page };

struct FilmOptions {
  Motion motion = Motion::turntable;
  double seconds = 8.0;  ///< of the whole film
  int framesPerSecond = 25;
  FilmFormat format = FilmFormat::hd;
  int width = 1280;  ///< pixels; of `typed`
  int height = 720;  ///< pixels; of `typed` and `page`
  /// Seconds of rest at each view, or at either end of Γ; absent: 2/5 or 1/6 of the film in total.
  std::optional<double> hold;
  std::vector<model::NodeId> swept;  ///< structures of which Γ changes; empty: all
  bool subtitles = false;            ///< what views say is written as a WebVTT file, too
};
inline constexpr Limits<double> filmSecondsLimits{0.1, 600.0};
inline constexpr Limits<int> framesPerSecondLimits{1, 60};
/// Limits of the film's height, and of its width.
inline constexpr Limits<int> filmHeightLimits{16, 4320};
inline constexpr Limits<double> holdLimits{0.0, 600.0};

OptionList filmOptions();

extern const ExportOption motionOption;
extern const ExportOption filmFormatOption;
extern const ExportOption filmWidthOption;
extern const ExportOption filmHeightOption;

/// Returns the film's size in pixels; both sides are even, as films require.
glm::ivec2 filmSize(const ExportOrder& order);
/// Returns the size of the order's page as a film has it: of the film's shape, or the page's where
/// it has that, and so small that letters can be read on a screen, whatever paper other kinds have:
/// 10 points are 1/30 of the shorter side.
glm::vec2 filmPageMm(const ExportOrder& order);

}  // namespace sline::render
