// SPDX-License-Identifier: Apache-2.0
// Names as people type them on a command line, and as they are shown there.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// Up to five of the names that are most like the wanted one, best first: those that contain it or
/// that it contains, then those a few typing errors away.
std::vector<std::string> nearNames(std::string_view wanted, std::span<const std::string> names);

/// The structures and groups of that name, at least one; the error lists names that are near.
Result<std::vector<model::NodeId>> nodesNamed(const model::Scene& scene, std::string_view name);

/// "no <what> is named X" and the near names, as a wrong use.
Error unknownName(std::string_view what, std::string_view name, std::span<const std::string> names);

/// Words come from files: what would move the terminal's cursor is left out.
std::string onOneLine(std::string text);

}  // namespace sline::cli
