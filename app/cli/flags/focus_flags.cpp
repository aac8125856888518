// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/focus_flags.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/cli/files/names.h"
#include "app/cli/files/progress.h"
#include "model/focus/nearness.h"

namespace sline::cli {

namespace {

/// Splits "liver,left kidney" in two, unless that is a name.
std::vector<std::string> split(const model::Scene& scene, const std::string& text) {
  if (!scene.named(text).empty())
    return {text};
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

Result<std::vector<model::NodeId>> allNamed(const model::Scene& scene,
                                            const std::vector<std::string>& texts) {
  std::vector<model::NodeId> all;
  for (const std::string& text : texts)
    for (const std::string& name : split(scene, text)) {
      const auto ids = TRY(nodesNamed(scene, name));
      all.insert(all.end(), ids.begin(), ids.end());
    }
  return all;
}

/// Reads "12,-40.5,80", a place in LPS millimetres; nothing where it is no such text.
std::optional<glm::vec3> placeFrom(std::string_view text) {
  std::array<float, 3> at{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const char* end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, at[i]);
    const bool last = i + 1 == at.size();
    if (failure != std::errc{} || !std::isfinite(at[i]) || (rest == end) != last ||
        (!last && *rest != ','))
      return std::nullopt;
    text.remove_prefix(std::size_t(rest - text.data()) + (last ? 0 : 1));
  }
  return glm::vec3(at[0], at[1], at[2]);
}

Result<model::Scene> nearFocused(const model::Scene& scene, const FocusSpec& spec,
                                 const model::Scene& cut, const model::Camera& camera) {
  model::NearFocus focus{
      .targets = {},
      .nearness = {.place = {}, .falloffMm = spec.falloffMm.value_or(model::usualFalloffMm(cut))}};
  if (scene.named(spec.near).empty())
    focus.nearness.place = placeFrom(spec.near);
  if (!focus.nearness.place) {
    focus.targets = TRY(allNamed(scene, {spec.near}));
  }
  model::MeshTrees trees;
  return model::withNearFocus(scene, focus, model::structuresBefore(cut, focus, camera, trees))
      .scene;
}

}  // namespace

Result<FocusSpec> parseFlags(const FocusFlags& flags) {
  FocusSpec spec;
  spec.names = flags.names;
  const auto amount = model::ContextAmount::from(float(flags.context));
  if (!amount)
    return Error{.reason = "--context is out of range", .remedy = "Give 0 to 1"};
  spec.context = *amount;
  if (flags.from != "around" && flags.from != "camera")
    return Error{.reason = "--context-from " + flags.from + " is unknown",
                 .remedy = "Give --context-from around or --context-from camera"};
  spec.fromCamera = flags.from == "camera";
  if (flags.names.empty() && (flags.contextGiven || !spec.fromCamera))
    return Error{.reason = "context is given without a focus", .remedy = "Add --focus NAME"};
  spec.near = flags.near;
  if (flags.falloff)
    spec.falloffMm = float(*flags.falloff);
  if (spec.falloffMm && !model::nearnessFalloffs.contain(*spec.falloffMm))
    return Error{.reason = "--falloff is out of range", .remedy = "Give 1 to 2000 mm"};
  if (flags.near.empty() && flags.falloff)
    return Error{.reason = "a falloff is given without what it is from",
                 .remedy = "Add --focus-near NAME or --focus-near X,Y,Z"};
  if (!flags.near.empty() && !flags.names.empty())
    return Error{.reason = "--focus and --focus-near are two ways to the same",
                 .remedy = "Leave one of them out"};
  return spec;
}

Result<model::Scene> focused(const model::Scene& scene, const FocusSpec& spec,
                             const model::Scene& cut, const model::Camera& camera) {
  if (!spec.near.empty())
    return nearFocused(scene, spec, cut, camera);
  if (spec.names.empty())
    return scene;
  std::vector<model::NodeId> named = TRY(allNamed(scene, spec.names));
  const std::vector<model::NodeId>& targets = named;
  model::FormIndex forms;
  model::FocusQuestion question{.targets = targets};
  if (spec.fromCamera)
    question.camera = camera;
  const auto analysis = model::analysed(cut, question, forms);
  if (!analysis) {
    warn("nothing is left of what --focus names");
    return scene;
  }
  return model::withFocusAndContext(scene, *analysis, spec.context).scene;
}

}  // namespace sline::cli
