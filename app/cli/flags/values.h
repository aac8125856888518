// SPDX-License-Identifier: Apache-2.0
// The values that flags take, parsed with messages that say what would have been right.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/import/plan/import.h"
#include "model/scene/style.h"
#include "render/export/order/export_order.h"
#include "render/strokes/picture_settings.h"

namespace sline::cli {

/// A picture's width and height in pixels.
struct Size {
  int width = 1280;
  int height = 720;
  float aspect() const { return float(width) / float(height); }
};

/// "1920x1080"; both sides within `render::pixelSideLimits`.
Result<Size> parseSize(std::string_view text);
/// "auto" (nothing) or a number from 1 to `render::mostSamples`.
Result<std::optional<int>> parseSamples(const std::string& text);
/// "2.5", within [0, 5].
Result<Gamma> parseGamma(std::string_view text);
/// Styles that say this one thing: a number within its range.
Result<model::Style> parsePen(std::string_view text);
Result<model::Style> parseHatchDensity(std::string_view text);
Result<model::Style> parseHatchTone(std::string_view text);
/// "#rrggbb".
Result<Colour> parseColour(std::string_view text);
/// "LPS", "RAS" or "file"; case is ignored.
Result<model::Frame> parseFrame(std::string_view text);
/// "mm", "cm", "m" or "inch": how many millimetres it is long.
Result<float> parseUnit(std::string_view text);
/// "auto", "off" or a number of steps from 1 to 1000.
Result<model::Smoothing> parseSmoothing(std::string_view text);
/// "NAME=VALUE", "NAME=LO..HI" (either may be left out) or the name of a preset.
Result<model::Threshold> parseThreshold(std::string_view text);
Result<model::Fill> parseFill(std::string_view text);
Result<render::Background> parseBackground(const std::string& text);
/// "strokes" or "as-printed".
Result<render::HatchingMethod> parseHatching(std::string_view text);
/// A direction as `PictureSettings::light`.
Result<glm::vec3> parseLight(std::string_view text);

/// "NAME=VALUE", cut at the last '='; nothing where there is none.
struct NamedValue {
  std::string name;
  std::string value;
};
std::optional<NamedValue> splitNamed(std::string_view text);

std::string_view frameName(model::Frame frame);

}  // namespace sline::cli
