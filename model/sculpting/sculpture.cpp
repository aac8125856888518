// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/sculpture.h"

#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "model/sculpting/stopping.h"

namespace sline::model {

namespace {
/// The distance to an empty shape, in mm.
constexpr float nothing = 1000.0f;

template <class Shape>
Field fieldOf(const Shape& shape) {
  return [shared = std::make_shared<const Shape>(shape)](const glm::vec3& p) {
    return shared->distance(p);
  };
}
}  // namespace

void Sculpture::add(Field shape, const Box& box, float blend) {
  m_steps.push_back({std::move(shape), blend, false});
  m_bounds.add(box);
}

void Sculpture::carve(Field shape, float blend) {
  m_steps.push_back({std::move(shape), blend, true});
}

void Sculpture::cut(const glm::vec3& point, const glm::vec3& normal, float blend) {
  const glm::vec3 n = glm::normalize(normal);
  carve([point, n](const glm::vec3& p) { return glm::dot(point - p, n); }, blend);
}

void Sculpture::addTube(const Tube& tube, float blend) {
  add(fieldOf(tube), tube.bounds(), blend);
}

void Sculpture::addPlate(const Lamina& plate, float blend) {
  add(fieldOf(plate), plate.bounds(), blend);
}

void Sculpture::carveTube(const Tube& tube, float blend) {
  carve(fieldOf(tube), blend);
}

void Sculpture::addTubePair(const Tube& tube, float blend) {
  addTube(tube, blend);
  add(mirrored(fieldOf(tube), m_middle), mirrored(tube.bounds(), m_middle), blend);
}

void Sculpture::addPlatePair(const Lamina& plate, float blend) {
  addPlate(plate, blend);
  add(mirrored(fieldOf(plate), m_middle), mirrored(plate.bounds(), m_middle), blend);
}

void Sculpture::carveTubePair(const Tube& tube, float blend) {
  carveTube(tube, blend);
  carve(mirrored(fieldOf(tube), m_middle), blend);
}

float Sculpture::Step::onto(float d, float value) const {
  return carves ? blendedDifference(d, value, blend) : blendedUnion(d, value, blend);
}

float Sculpture::distance(const glm::vec3& p) const {
  float d = nothing;
  for (const Step& step : m_steps)
    d = step.onto(d, step.shape(p));
  return d;
}

std::vector<const Sculpture::Step*> Sculpture::near(const glm::vec3& place, float reach) const {
  // No shape's value changes by more than the distance between two places; a shape that cannot come
  // within its blend of the shape so far has no effect. Later carvings only raise a value.
  std::vector<const Step*> steps;
  float d = nothing;
  for (const Step& step : m_steps) {
    const float shape = step.shape(place);
    const bool matters = step.carves ? -shape + step.blend > d - 2.0f * reach
                                     : shape - step.blend < d + 2.0f * reach;
    if (matters)
      steps.push_back(&step);
    d = step.onto(d, shape);
  }
  return steps;
}

Field Sculpture::sampled(SampledField::Fineness fineness, const std::stop_token& stop) const {
  constexpr float margin = 8.0f;
  const Box box{m_bounds.low - margin, m_bounds.high + margin};
  const auto local = [this, &stop](const glm::vec3& place, float reach) -> Field {
    goOnUnless(stop);
    return [steps = near(place, reach)](const glm::vec3& p) {
      float d = nothing;
      for (const Step* step : steps)
        d = step->onto(d, step->shape(p));
      return d;
    };
  };
  const auto samples = std::make_shared<const SampledField>(local, box, fineness);
  return [samples](const glm::vec3& p) { return samples->distance(p); };
}

}  // namespace sline::model
