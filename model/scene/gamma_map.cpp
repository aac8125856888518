// SPDX-License-Identifier: Apache-2.0
#include "model/scene/gamma_map.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>

namespace sline::model {

namespace {

/// Reads the whole text as a number with any sign, in any locale.
std::optional<float> signedNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-"))
    text.remove_prefix(1);
  float value = 0.0f;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || text.empty())
    return std::nullopt;
  return value;
}

std::string written(float number) {
  std::array<char, 32> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end};
}

bool isFinite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Returns the map with its offsets times that.
GammaMap flattened(GammaMap map, float share) {
  for (GammaPoint& point : map.curve)
    point.offset *= share;
  return map;
}

}  // namespace

float GammaMap::offsetAt(float value) const {
  if (scalar == GammaScalar::none || curve.empty())
    return 0.0f;
  const auto after = std::find_if(curve.begin(), curve.end(), [value](const GammaPoint& point) {
    return point.scalar > value;
  });
  if (after == curve.begin())
    return curve.front().offset;
  if (after == curve.end())
    return curve.back().offset;
  const GammaPoint& before = *(after - 1);
  const float part = (value - before.scalar) / (after->scalar - before.scalar);
  return std::lerp(before.offset, after->offset, part);
}

std::optional<std::string_view> curveFault(std::span<const GammaPoint> curve) {
  if (curve.size() < fewestGammaPoints || curve.size() > mostGammaPoints)
    return "a curve has 2 to 8 points";
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!gammaScalars.contain(curve[i].scalar))
      return "a scalar lies from -1000000 to 1000000";
    if (!gammaOffsets.contain(curve[i].offset))
      return "an offset lies from -5 to 5";
    if (i > 0 && !(curve[i].scalar > curve[i - 1].scalar))
      return "the scalars of a curve ascend";
  }
  return std::nullopt;
}

std::optional<std::string_view> gammaMapFault(const GammaMap& map) {
  if (map.scalar == GammaScalar::none)
    return map == GammaMap() ? std::nullopt
                             : std::optional<std::string_view>(
                                   "no scalar has neither curve nor "
                                   "targets");
  if (map.scalar != GammaScalar::distance && (!map.targets.empty() || map.place))
    return "only distances have targets";
  if (map.place && !isFinite(*map.place))
    return "its place is nowhere";
  if (map.targets.size() > mostGammaTargets)
    return "there are more than 1000 targets";
  return curveFault(map.curve);
}

std::vector<GammaPoint> usualCurve(GammaScalar scalar) {
  switch (scalar) {
    case GammaScalar::occlusion:
      return {{0.25f, 0.0f}, {0.75f, 3.0f}};
    case GammaScalar::curvature:
      return {{-2.0f, 3.0f}, {0.0f, 0.0f}};
    case GammaScalar::distance:
      return {{10.0f, 3.0f}, {40.0f, -1.0f}};
    case GammaScalar::painted:
      return {{0.0f, 0.0f}, {1.0f, 3.0f}};
    case GammaScalar::none:
      break;
  }
  return {};
}

Result<std::vector<GammaPoint>> curveFromText(std::string_view text) {
  constexpr const char* right =
      "Give 2 to 8 pairs SCALAR:OFFSET with ascending scalars and offsets from -5 to 5, such as "
      "0:+3,40:-1";
  std::vector<GammaPoint> curve;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view pair = rest.substr(0, comma);
    more = comma != std::string_view::npos;
    rest = more ? rest.substr(comma + 1) : std::string_view();
    const std::size_t colon = pair.find(':');
    std::optional<float> scalar;
    std::optional<float> offset;
    if (colon != std::string_view::npos) {
      scalar = signedNumber(pair.substr(0, colon));
      offset = signedNumber(pair.substr(colon + 1));
    }
    if (!scalar || !offset || curve.size() == mostGammaPoints + 1)
      return Error{.where = "point " + std::to_string(curve.size() + 1) + " of the curve",
                   .reason = "\"" + std::string(pair) + "\" is not understood",
                   .remedy = right};
    curve.push_back({*scalar, *offset});
  }
  if (const auto fault = curveFault(curve))
    return Error{
        .where = "the curve " + std::string(text), .reason = std::string(*fault), .remedy = right};
  return curve;
}

std::string curveText(std::span<const GammaPoint> curve) {
  std::string text;
  for (const GammaPoint& point : curve)
    text += (text.empty() ? "" : ",") + written(point.scalar) + ":" +
            (point.offset > 0.0f ? "+" : "") + written(point.offset);
  return text;
}

GammaMap between(const GammaMap& from, const GammaMap& to, float part) {
  if (from == to || part <= 0.0f)
    return from;
  if (part >= 1.0f)
    return to;
  if (from.scalar == to.scalar && from.targets == to.targets &&
      from.place.has_value() == to.place.has_value() && from.curve.size() == to.curve.size()) {
    GammaMap map = from;
    if (map.place)
      map.place = glm::mix(*from.place, *to.place, part);
    for (std::size_t i = 0; i < map.curve.size(); ++i) {
      map.curve[i].scalar = std::lerp(from.curve[i].scalar, to.curve[i].scalar, part);
      map.curve[i].offset = std::lerp(from.curve[i].offset, to.curve[i].offset, part);
    }
    return map;
  }
  if (from.scalar == GammaScalar::none)
    return flattened(to, part);
  if (to.scalar == GammaScalar::none)
    return flattened(from, 1.0f - part);
  return part < 0.5f ? flattened(from, 1.0f - 2.0f * part) : flattened(to, 2.0f * part - 1.0f);
}

}  // namespace sline::model
