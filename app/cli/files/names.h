// SPDX-License-Identifier: Apache-2.0
// Handles names as people type them on a command line, and as they are shown there.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/scene/near_names.h"
#include "model/scene/scene.h"

namespace sline::cli {

using model::nearNames;

/// Returns the structures and groups of that name, at least one: those whose own name it is, else
/// those that it names in any language or by a synonym (model::AnatomicalNames), else the one whose
/// path through its groups it is ("group / name"). The error lists
/// names that are near.
Result<std::vector<model::NodeId>> nodesNamed(const model::Scene& scene, std::string_view name);

/// Returns the error where the name is that of several structures and one is meant: it lists them.
Error ambiguousName(const model::Scene& scene, std::string_view name,
                    std::span<const model::NodeId> ids);

/// Returns "no <what> is named X" with the near names, as an error of wrong use.
Error unknownName(std::string_view what, std::string_view name, std::span<const std::string> names);

/// Returns the text on one line. Words come from files, so characters that would move the
/// terminal's cursor are left out.
std::string onOneLine(std::string text);

}  // namespace sline::cli
