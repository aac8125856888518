// SPDX-License-Identifier: Apache-2.0
// Finds links in texts: "[ureter](#structure=left-ureter)" lights a structure up,
// "[from behind](#view=2)" or "(#view=posterior)" goes to a view.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/scene.h"

namespace sline::render {

/// A piece of text, and where it leads.
struct LinkedPiece {
  std::string text;
  std::optional<model::NodeId> structure;
  std::optional<int> view;  ///< its number, from 1
  bool operator==(const LinkedPiece&) const = default;
};

/// Returns the text in pieces. A link to what the scene lacks is text without one.
std::vector<LinkedPiece> linkedPieces(std::string_view text, const model::Scene& scene);

}  // namespace sline::render
