// SPDX-License-Identifier: Apache-2.0
// Keeps the colours that structures had before a drawing style gave them others.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/scene/scene.h"

namespace sline::widgets {

/// Styles of few colours write their own over those of the structures, and the next style, or a
/// plate, must not take these for what they had. What was said of one document holds for no other.
class DrawnColours {
 public:
  /// Notes that a style was given to the document of that opening.
  void note(int opening, const model::Scene& before, const model::Scene& after);
  /// Returns the scene of that opening with the colours that styles have taken: where a structure
  /// still has the colour of a style, it gets the one that it had before. Those that were changed
  /// since, by hand or otherwise, and locked ones stay.
  model::Scene givenBack(int opening, const model::Scene& scene) const;

 private:
  struct Change {
    std::optional<Colour> had;
    std::optional<Colour> given;
  };
  /// By node, the latest change last.
  using Changes = std::map<model::NodeId, std::vector<Change>>;
  std::map<int, Changes> m_changes;  ///< by opening
};

}  // namespace sline::widgets
