// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Leads from one look of a scene to another, for the pictures in between: Γ, opacity, colours and
/// pens change evenly, structures shown at only one end appear or vanish, and sections that have
/// the same direction at both ends slide. Structures that are not at both ends, and everything that
/// is not a look, are as at the end.
class SceneBlend {
 public:
  SceneBlend(const Scene& from, Scene to);
  /// Returns the scene at `part` of the way, 0 … 1; it changes slowly at both ends and is exactly
  /// the last scene at the end.
  Scene at(double part) const;
  const Scene& end() const { return m_to; }

 private:
  struct Way {
    std::size_t node = 0;  ///< index among the nodes
    ResolvedStyle from;
    ResolvedStyle to;
  };
  Scene m_to;
  std::vector<Way> m_ways;  ///< one for each structure
  struct Slide {
    std::size_t section = 0;
    double from = 0.0;  ///< the plane's offset at the start
  };
  std::vector<Slide> m_slides;
};

}  // namespace sline::model
