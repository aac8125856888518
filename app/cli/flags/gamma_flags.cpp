// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/gamma_flags.h"

#include "app/cli/files/names.h"
#include "app/cli/flags/values.h"

namespace sline::cli {

namespace {
constexpr const char* rightTarget = "Write distance:STRUCTURE, such as liver=distance:tumour";
}

Result<GammaMapWish> parseGammaMap(std::string_view text) {
  const std::size_t at = text.rfind('@');
  const std::string_view what = text.substr(0, at);
  const std::size_t colon = what.find(':');
  const std::size_t scalar =
      TRY(parseName(model::gammaScalarNames, "what gamma follows,", what.substr(0, colon)));
  GammaMapWish wish{.map = {.scalar = model::GammaScalar(scalar)}, .target = {}};
  const bool toTargets = wish.map.scalar == model::GammaScalar::distance;
  if (colon != std::string_view::npos)
    wish.target = what.substr(colon + 1);
  if (toTargets && model::normalisedName(wish.target).empty())
    return Error{.reason = "\"" + std::string(text) + "\" does not say from what the distance is",
                 .remedy = rightTarget};
  if (!toTargets && colon != std::string_view::npos)
    return Error{.reason = "only a distance is from something, not \"" + std::string(what) + "\"",
                 .remedy = rightTarget};
  wish.map.curve = model::usualCurve(wish.map.scalar);
  if (at == std::string_view::npos)
    return wish;
  wish.map.curve = TRY(model::curveFromText(text.substr(at + 1)));
  if (wish.map.scalar == model::GammaScalar::none)
    return Error{.reason = "\"" + std::string(text) + "\" has a curve, but follows nothing",
                 .remedy = "Leave out what begins with @"};
  return wish;
}

Result<model::GammaMap> gammaMapIn(const model::Scene& scene, const GammaMapWish& wish) {
  model::GammaMap map = wish.map;
  if (wish.target.empty())
    return map;
  map.targets = TRY(nodesNamed(scene, wish.target));
  if (const auto fault = model::gammaMapFault(map))
    return Error{.reason = "the distance from \"" + wish.target +
                           "\" cannot be followed: " + std::string(*fault),
                 .remedy = "Name a group that holds them"};
  return map;
}

}  // namespace sline::cli
