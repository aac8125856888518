// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/cli/flags/typed_options.h"
#include "model/base/colour_text.h"
#include "model/base/letters.h"
#include "model/import/naming/laterality.h"
#include "model/import/volumes/threshold_presets.h"
#include "model/scene/light.h"
#include "render/export/order/common_options.h"
#include "render/export/pixels/pixel_options.h"

namespace sline::cli {

namespace {

template <class T>
struct Choice {
  std::string_view name;
  T value;
};

constexpr std::array<Choice<float>, 5> units{
    {{"mm", 1.0f}, {"cm", 10.0f}, {"m", 1000.0f}, {"inch", 25.4f}, {"um", 0.001f}}};
constexpr std::array<Choice<render::HatchingMethod>, 2> hatchingMethods{
    {{"strokes", render::HatchingMethod::strokes},
     {"as-printed", render::HatchingMethod::asPrinted}}};

constexpr std::array<Choice<glm::vec3>, 3> lights{
    {{"upper-left", model::upperLeftLight},
     {"above", glm::vec3(0.0f, 0.81f, 0.586f)},
     {"upper-right", model::upperLeftLight* glm::vec3(-1.0f, 1.0f, 1.0f)}}};

Error unreadableValue(std::string_view what, std::string_view text, std::string_view right) {
  return Error{.reason = std::string(what) + " \"" + std::string(text) + "\" is not understood",
               .remedy = "Give " + std::string(right)};
}

/// Returns the value of the row that has the name, whatever its case.
template <class T, class Row, std::size_t N>
Result<T> valueOf(const std::array<Row, N>& rows, T Row::*value, std::string_view what,
                  std::string_view text) {
  std::string names = "one of";
  for (const Row& row : rows) {
    if (equalsIgnoringCase(row.name, text))
      return row.*value;
    names += (&row == &rows.front() ? " " : ", ") + std::string(row.name);
  }
  return unreadableValue(what, text, names);
}

template <class T, std::size_t N>
Result<T> parseChoice(const std::array<Choice<T>, N>& choices, std::string_view what,
                      std::string_view text) {
  return valueOf(choices, &Choice<T>::value, what, text);
}

/// Reads the whole text as a number, in any locale.
template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

}  // namespace

Result<Size> parseSize(std::string_view text) {
  const std::string right = "WIDTHxHEIGHT in pixels, each from " +
                            std::to_string(render::pixelSideLimits.low) + " to " +
                            std::to_string(render::pixelSideLimits.high) + ", such as 1920x1080";
  const std::size_t cut = text.find_first_of("xX");
  if (cut == std::string_view::npos)
    return unreadableValue("size", text, right);
  const auto width = number<int>(text.substr(0, cut));
  const auto height = number<int>(text.substr(cut + 1));
  if (!width || !height)
    return unreadableValue("size", text, right);
  const auto [low, high] = std::minmax(*width, *height);
  if (low < render::pixelSideLimits.low || high > render::pixelSideLimits.high)
    return Error{.reason = "size " + std::string(text) + " is out of range",
                 .remedy = "Give " + right};
  return Size{*width, *height};
}

Result<std::optional<int>> parseSamples(const std::string& text) {
  const render::OptionValue samples = TRY(parseTypedOption(render::samplesOption, text));
  const int number = std::get<int>(samples);
  return number > 0 ? std::optional(number) : std::nullopt;
}

Result<Gamma> parseGamma(std::string_view text) {
  constexpr std::string_view right =
      "a number from 0 (silhouette) to 5 (shaded surface), or NAME=NUMBER for one structure or "
      "group";
  const auto value = number<float>(text);
  if (!value)
    return unreadableValue("gamma", text, right);
  const auto gamma = Gamma::from(*value);
  if (!gamma)
    return Error{.reason = "gamma " + std::string(text) + " is out of range",
                 .remedy = "Give " + std::string(right)};
  return *gamma;
}

Result<float> parseWithin(std::string_view what, std::string_view text,
                          const Limits<float>& limits) {
  const std::string right = "a number from " + std::to_string(int(limits.low)) + " to " +
                            std::to_string(int(limits.high)) +
                            " (1 is the usual), or NAME=NUMBER for one structure or group";
  const auto value = number<float>(text);
  if (!value)
    return unreadableValue(what, text, right);
  if (!(*value >= limits.low && *value <= limits.high))
    return Error{.reason = std::string(what) + " " + std::string(text) + " is out of range",
                 .remedy = "Give " + right};
  return *value;
}

Result<Colour> parseColour(std::string_view text) {
  if (const std::optional<Colour> colour = colourFrom(text))
    return *colour;
  return unreadableValue("colour", text, "NAME=#rrggbb, such as liver=#a0523c");
}

Result<model::Frame> parseFrame(std::string_view text) {
  return valueOf(model::frames, &model::FrameAxes::frame, "frame", text);
}

Result<float> parseUnit(std::string_view text) {
  if (const auto millimetres = number<float>(text)) {
    if (std::isfinite(*millimetres) && *millimetres > 0.0f)
      return *millimetres;
    return Error{.reason = "a unit of " + std::string(text) + " mm has no length",
                 .remedy = "Give millimetres above 0, or mm, cm, m, inch or um"};
  }
  return parseChoice(units, "unit", text);
}

std::string unitFlag(float millimetres) {
  const auto named = std::find_if(units.begin(), units.end(), [millimetres](const auto& unit) {
    return unit.value == millimetres;
  });
  if (named != units.end())
    return "--unit " + std::string(named->name);
  std::ostringstream text;
  text << "--unit " << millimetres;
  return text.str();
}

Result<model::Smoothing> parseSmoothing(std::string_view text) {
  using Mode = model::Smoothing::Mode;
  if (equalsIgnoringCase(text, "auto"))
    return model::Smoothing{Mode::automatic, 0};
  if (equalsIgnoringCase(text, "off"))
    return model::Smoothing{Mode::off, 0};
  constexpr std::string_view right = "auto, off or a number of smoothing steps from 1 to 1000";
  const auto steps = number<int>(text);
  if (!steps)
    return unreadableValue("smoothing", text, right);
  if (*steps < 1 || *steps > 1000)
    return Error{.reason = "smoothing " + std::string(text) + " is out of range",
                 .remedy = "Give " + std::string(right)};
  return model::Smoothing{Mode::steps, *steps};
}

Result<model::Threshold> parseThreshold(std::string_view text) {
  const std::string right = "NAME=VALUE, NAME=LO..HI, or " + model::presetList();
  const auto named = splitNamed(text);
  if (!named) {
    if (!model::presetNamed(text))
      return unreadableValue("threshold", text, right);
    return model::Threshold{std::string(model::presetNamed(text)->name), {}, {}};
  }
  model::Threshold threshold{named->name, {}, {}};
  const std::string_view value = named->value;
  const std::size_t dots = value.find("..");
  const auto bound = [](std::string_view word, std::optional<double>& to) {
    to = number<double>(word);
    return word.empty() || (to && std::isfinite(*to));
  };
  const bool fine = dots == std::string_view::npos
                        ? bound(value, threshold.low)
                        : bound(value.substr(0, dots), threshold.low) &&
                              bound(value.substr(dots + 2), threshold.high);
  if (named->name.empty() || !fine || (!threshold.low && !threshold.high))
    return unreadableValue("threshold", text, right);
  if (threshold.low && threshold.high && *threshold.low > *threshold.high)
    return Error{.reason = "the threshold " + std::string(text) + " begins above its end",
                 .remedy = "Give the lower number first"};
  return threshold;
}

Result<std::size_t> parseName(std::span<const std::string_view> names, std::string_view what,
                              std::string_view text) {
  std::string all = "one of";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (equalsIgnoringCase(names[i], text))
      return i;
    all += (i == 0 ? " " : ", ") + std::string(names[i]);
  }
  return unreadableValue(what, text, all);
}

Result<model::Fill> parseFill(std::string_view text) {
  const std::size_t place = TRY(parseName(model::fillNames, "fill", text));
  return model::Fill(place);
}

Result<render::Background> parseBackground(const std::string& text) {
  const render::OptionValue background = TRY(parseTypedOption(render::backgroundOption, text));
  return render::fromOptionValue<render::Background>(background);
}

Result<render::HatchingMethod> parseHatching(std::string_view text) {
  return parseChoice(hatchingMethods, "hatching", text);
}

Result<glm::vec3> parseLight(std::string_view text) {
  return parseChoice(lights, "light", text);
}

std::optional<NamedValue> splitNamed(std::string_view text) {
  const std::size_t cut = text.rfind('=');
  if (cut == std::string_view::npos)
    return std::nullopt;
  return NamedValue{std::string(text.substr(0, cut)), std::string(text.substr(cut + 1))};
}

}  // namespace sline::cli
