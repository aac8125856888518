// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/focus_flags.h"

#include "app/cli/files/names.h"
#include "app/cli/files/progress.h"

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
  return spec;
}

Result<model::Scene> focused(const model::Scene& scene, const FocusSpec& spec,
                             const model::Scene& cut, const model::Camera& camera) {
  if (spec.names.empty())
    return scene;
  std::vector<model::NodeId> targets;
  for (const std::string& text : spec.names)
    for (const std::string& name : split(scene, text)) {
      const auto ids = nodesNamed(scene, name);
      if (!ids.ok())
        return ids.error();
      targets.insert(targets.end(), ids->begin(), ids->end());
    }
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
