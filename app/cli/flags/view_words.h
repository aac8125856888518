// SPDX-License-Identifier: Apache-2.0
// Reads what `sline view` is to say with a view.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::cli {

struct ViewWordFlags {
  std::vector<std::string> title;
  std::vector<std::string> text;
  std::vector<std::string> notes;
  std::vector<std::string> alt;
  std::optional<float> seconds;

  bool any() const {
    return !title.empty() || !text.empty() || !notes.empty() || !alt.empty() || seconds;
  }
};

/// Declares the flags; returns them, so that a command can say what they go with.
std::vector<CLI::Option*> addViewWordOptions(CLI::App& command, ViewWordFlags& flags);

/// Returns the words as the flags change them. Flags that say nothing leave what there is; the
/// error names the flag.
Result<model::ViewWords> withWordFlags(const model::ViewWords& words, const ViewWordFlags& flags);

/// Returns title, text, notes, alt and seconds as the list for programs has them: texts by
/// language, "" for the scene's own.
nlohmann::json jsonWords(const model::ViewWords& words);

}  // namespace sline::cli
