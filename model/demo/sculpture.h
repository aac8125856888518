// SPDX-License-Identifier: Apache-2.0
// Bones are modelled as from clay: plates, tubes and lumps are added and hollows carved, one after
// the other, each blended into what is there.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/demo/implicit.h"

namespace sline::model {

class Sculpture {
 public:
  /// Adds or carves a shape; the seam is rounded over about `blend` mm, at most 12. `box` holds the
  /// shape.
  void add(Field shape, const Box& box, float blend);
  void carve(Field shape, float blend);

  void addTube(std::span<const TubePoint> through, float blend);
  void carveTube(std::span<const TubePoint> through, float blend);
  /// A plate through a net of points, `columns` to a row (see Sheet).
  void addSheet(std::span<const TubePoint> net, std::size_t columns, float blend);
  /// Removes what lies beyond the plane through `point`, on the side its normal points to.
  void cut(const glm::vec3& point, const glm::vec3& normal, float blend);

  float distance(const glm::vec3& p) const;
  /// The same shape, read in constant time (see SampledField).
  Field sampled(float spacing) const;
  /// Holds everything added.
  const Box& bounds() const { return m_bounds; }

 private:
  struct Step {
    Field shape;
    float blend;
    bool carves;
    float onto(float d, float value) const;
  };
  std::vector<const Step*> near(const glm::vec3& place, float reach) const;
  std::vector<Step> m_steps;
  Box m_bounds;
};

/// Points reflected in the plane x = middle.
std::vector<TubePoint> mirrored(std::span<const TubePoint> points, float middle);

}  // namespace sline::model
