// SPDX-License-Identifier: Apache-2.0
// Says whose work surfaces are.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/edit/edited.h"

namespace sline::model {

/// Returns the credit with each field one line of UTF-8 without control characters. How long it may
/// be model/scene/scene_limits.h says.
SourceCredit tidied(const SourceCredit& credit);

/// Says what is to be said; what is absent stays as it is, and an empty text takes it away.
struct CreditChange {
  std::optional<std::string> authors;
  std::optional<std::string> source;
  std::optional<std::string> licence;
};

/// Changes whose work all structures at or below the nodes are said to be.
Edited withCredit(const Scene& scene, std::span<const NodeId> ids, const CreditChange& change);

}  // namespace sline::model
