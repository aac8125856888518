// SPDX-License-Identifier: Apache-2.0
// Finds structures that would only be drawn over themselves: a scene may have one surface thousands
// of times.
#pragma once

#include <map>
#include <vector>

#include "render/drawn/drawn_structure.h"

namespace sline::render {

/// Returns how many structures of that style show that lie in one place, the nearest first: what
/// lies behind these would change no pixel by more than its rounding. Lines over their like, too,
/// are one line.
int showingInOnePlace(const model::ResolvedStyle& style);

/// Takes structures in the order in which they lie in front of each other where they coincide.
class Coinciding {
 public:
  /// Returns whether as many as show have the same surface, cut alike, and the same style, but for
  /// colours. The structure must live as long as this object.
  bool isBuried(const DrawnStructure& shown);

 private:
  struct Alike {
    const DrawnStructure* first;
    int count;
  };
  std::map<const model::Mesh*, std::vector<Alike>> m_seen;
};

}  // namespace sline::render
