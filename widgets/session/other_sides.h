// SPDX-License-Identifier: Apache-2.0
// Knows which structures lie on the other side of the body than their names say.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/scene/scene.h"

namespace sline::widgets {

/// Compares names and places anew only where either has changed.
class OtherSides {
 public:
  /// Tells whether the structure does.
  bool has(const model::Scene& scene, model::NodeId structure);
  /// Says so of all in a sentence (model::otherSidesText), in English.
  const std::string& text(const model::Scene& scene);

 private:
  void follow(const model::Scene& scene);

  std::vector<std::pair<std::string, model::MeshPtr>> m_comparedOf;
  std::vector<model::NodeId> m_structures;
  std::string m_text;
};

}  // namespace sline::widgets
