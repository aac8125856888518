// SPDX-License-Identifier: Apache-2.0
// Parses the values that flags take, with messages that say what would have been right.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/import/plan/import.h"
#include "model/scene/style.h"
#include "render/drawn/picture_settings.h"
#include "render/export/order/export_order.h"

namespace sline::cli {

/// Holds a picture's width and height in pixels.
struct Size {
  int width = 1280;
  int height = 720;
  float aspect() const { return float(width) / float(height); }
};

/// Reads "1920x1080"; both sides within `render::pixelSideLimits`.
Result<Size> parseSize(std::string_view text);
/// Reads "auto" (nothing) or a number from 1 to `render::mostSamples`.
Result<std::optional<int>> parseSamples(const std::string& text);
/// Reads "2.5", within [0, 5].
Result<Gamma> parseGamma(std::string_view text);
/// Reads a number within the limits, of which 1 is the usual; errors call it `what`.
Result<float> parseWithin(std::string_view what, std::string_view text,
                          const Limits<float>& limits);
/// Reads "#rrggbb".
Result<Colour> parseColour(std::string_view text);
/// Reads a name of `model::frames`; case is ignored.
Result<model::Frame> parseFrame(std::string_view text);
/// Reads "mm", "cm", "m", "inch", "um" or a number of millimetres and returns its length in
/// millimetres.
Result<float> parseUnit(std::string_view text);
/// Returns "--unit cm", the flag that gives the length.
std::string unitFlag(float millimetres);
/// Reads "auto", "off" or a number of steps from 1 to 1000.
Result<model::Smoothing> parseSmoothing(std::string_view text);
/// Reads "NAME=VALUE", "NAME=LO..HI" (either may be left out) or the name of a preset.
Result<model::Threshold> parseThreshold(std::string_view text);
/// Reads one of the names, whatever their case, and returns its place; errors call it `what`.
Result<std::size_t> parseName(std::span<const std::string_view> names, std::string_view what,
                              std::string_view text);
Result<model::Fill> parseFill(std::string_view text);
Result<render::Background> parseBackground(const std::string& text);
/// Reads "strokes" or "as-printed".
Result<render::HatchingMethod> parseHatching(std::string_view text);
/// Reads a direction as `PictureSettings::light`.
Result<glm::vec3> parseLight(std::string_view text);

/// Holds "NAME=VALUE", cut at the last '='; a text without one gives nothing.
struct NamedValue {
  std::string name;
  std::string value;
};
std::optional<NamedValue> splitNamed(std::string_view text);

}  // namespace sline::cli
