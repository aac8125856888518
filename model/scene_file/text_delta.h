// SPDX-License-Identifier: Apache-2.0
// Says how one text becomes another, line by line. The journal describes edits by it, so that no
// list of what can be edited exists beside the one that saves.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sline::model {

/// Returns what changes `before` into `after`: a row of (bytes kept, bytes left out, length, bytes
/// put in). Few changed lines give few bytes, wherever they are.
std::string textDelta(std::string_view before, std::string_view after);

/// Returns the text after the change; absent where the delta, which is not trusted, does not fit.
/// The result is never longer than both together.
std::optional<std::string> withDelta(std::string_view before, std::string_view delta);

}  // namespace sline::model
