// SPDX-License-Identifier: Apache-2.0
// Models bones as from clay: plates, tubes and lumps are added and hollows carved, one after the
// other, each blended into the shape so far.
#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <stop_token>
#include <vector>

#include "model/sculpting/implicit.h"
#include "model/sculpting/lamina.h"
#include "model/sculpting/sampled_field.h"

namespace sline::model {

class Sculpture {
 public:
  /// Makes an empty sculpture; pairs are reflected in the plane x = `middle`.
  explicit Sculpture(float middle = 0.0f) : m_middle(middle) {}

  /// Adds a shape that lies within the box, or carves one; the seam is rounded over about `blend`
  /// mm, at most 12.
  void add(Field shape, const Box& box, float blend);
  void carve(Field shape, float blend);
  /// Removes everything beyond the plane through `point`, on the side its normal points to.
  void cut(const glm::vec3& point, const glm::vec3& normal, float blend);

  void addTube(const Tube& tube, float blend);
  void addPlate(const Lamina& plate, float blend);
  void carveTube(const Tube& tube, float blend);
  void addTubePair(const Tube& tube, float blend);
  void addPlatePair(const Lamina& plate, float blend);
  void carveTubePair(const Tube& tube, float blend);

  float distance(const glm::vec3& p) const;
  /// Returns the shape smoothed and readable in constant time. Throws ModellingStopped if `stop` is
  /// requested on the way.
  Field sampled(SampledField::Fineness fineness, const std::stop_token& stop = {}) const;
  /// Returns the box around everything added.
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
  float m_middle;
};

}  // namespace sline::model
