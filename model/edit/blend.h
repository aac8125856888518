// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// The way from one look of a scene to another, for pictures in between: Γ, opacity, colours and
/// pens change evenly, what is shown at one end only appears or leaves, and sections that have
/// their direction at both ends slide. Structures that are not at both ends, and all that is not
/// looks, are as at the end.
class SceneBlend {
 public:
  SceneBlend(const Scene& from, Scene to);
  /// `part` of the way, 0 … 1; slow at both ends, and exactly the last scene at the end.
  Scene at(double part) const;
  const Scene& end() const { return m_to; }

 private:
  struct Way {
    std::size_t node = 0;  ///< where it stands among the nodes
    ResolvedStyle from;
    ResolvedStyle to;
  };
  Scene m_to;
  std::vector<Way> m_ways;  ///< of all structures
  struct Slide {
    std::size_t section = 0;
    double from = 0.0;  ///< its plane's offset
  };
  std::vector<Slide> m_slides;
};

}  // namespace sline::model
