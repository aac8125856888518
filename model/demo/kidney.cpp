// SPDX-License-Identifier: Apache-2.0
// Measures after common anatomy textbooks: a kidney of 11 × 5.5 × 4 cm whose hilum faces medially
// and a little to the front; the vein in front of the artery, the renal pelvis behind both.
#include "model/demo/kidney.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/demo/implicit.h"
#include "model/demo/polygonise.h"
#include "model/demo/stopping.h"

namespace sline::model {

/// A bean: an ellipsoid bent around the hilum, its lower half a little fuller, with faint lobes and
/// a sinus that the vessels enter.
float kidneyField(const glm::vec3& p) {
  glm::vec3 q = p;
  q.x += 0.0065f * q.z * q.z;
  q.x += 0.10f * q.y;
  const float lower = 1.0f + 0.0011f * -q.z;
  float d = ellipsoid(q / lower, {27.0f, 20.0f, 55.0f}) * lower;
  d += 0.45f * std::sin(q.z * 0.17f + 0.6f) * std::sin(q.y * 0.13f + 0.3f);
  const float sinus = ellipsoid(p - glm::vec3(-24, -1, 0), {17.0f, 11.0f, 18.0f});
  return blendedDifference(d, sinus, 9.0f);
}

namespace {
using Tubes = std::vector<Tube>;

/// Branches of one vessel, blended where they part.
float branched(const Tubes& tubes, const glm::vec3& p, float blend) {
  float d = tubes.front().distance(p);
  for (std::size_t i = 1; i < tubes.size(); ++i)
    d = blendedUnion(d, tubes[i].distance(p), blend);
  return d;
}

Tubes arteryTubes() {
  return {
      Tube(std::array<TubePoint, 5>{{{{-62, 4, 6}, 3.6f},
                                     {{-46, 3, 5}, 3.3f},
                                     {{-33, 1, 3}, 3.1f},
                                     {{-22, -2, 9}, 2.3f},
                                     {{-8, -3, 19}, 1.5f}}}),
      Tube(std::array<TubePoint, 4>{
          {{{-46, 3, 5}, 3.1f}, {{-33, 1, 3}, 2.9f}, {{-20, -2, -1}, 2.3f}, {{-6, -4, 2}, 1.5f}}}),
      Tube(std::array<TubePoint, 4>{{{{-44, 3, 5}, 1.5f},
                                     {{-33, 1, 3}, 2.8f},
                                     {{-22, 0, -9}, 2.0f},
                                     {{-9, -2, -20}, 1.4f}}})};
}

Tubes veinTubes() {
  return {Tube(std::array<TubePoint, 5>{{{{-66, -11, 1}, 5.6f},
                                         {{-48, -12, 1}, 5.2f},
                                         {{-34, -10, 0}, 4.6f},
                                         {{-22, -9, 7}, 3.2f},
                                         {{-8, -9, 14}, 2.0f}}}),
          Tube(std::array<TubePoint, 4>{{{{-46, -12, 1}, 2.6f},
                                         {{-34, -10, 0}, 4.3f},
                                         {{-22, -8, -8}, 3.1f},
                                         {{-8, -9, -15}, 1.9f}}})};
}

/// The renal pelvis gathers two calyces and narrows into the ureter.
Tubes ureterTubes() {
  return {Tube(std::array<TubePoint, 7>{{{{-8, 6, 12}, 3.2f},
                                         {{-20, 8, 3}, 6.2f},
                                         {{-31, 9, -10}, 4.6f},
                                         {{-36, 9, -28}, 2.5f},
                                         {{-37, 7, -55}, 2.2f},
                                         {{-41, 4, -84}, 2.4f},
                                         {{-42, 3, -112}, 2.1f}}}),
          Tube(std::array<TubePoint, 4>{{{{-8, 6, -14}, 3.0f},
                                         {{-18, 8, -6}, 5.0f},
                                         {{-27, 8.5f, -6}, 5.6f},
                                         {{-32, 9, -14}, 4.2f}}})};
}

Box around(const Tubes& tubes, float margin) {
  Box box;
  for (const Tube& tube : tubes)
    box.add(tube.bounds());
  box.low -= margin;
  box.high += margin;
  return box;
}

NodeId addGroup(Scene& scene, const char* name) {
  return scene.append({.name = name});
}

struct Look {
  Colour colour;
  float gamma;
};

void addStructure(Scene& scene, NodeId group, const char* name, MeshPtr mesh, Look look) {
  scene.append({.parent = group,
                .name = name,
                .style = {.colour = look.colour, .gamma = Gamma::clamped(look.gamma)},
                .mesh = std::move(mesh),
                .provenance = {.frame = "LPS", .frameReason = "modelled in it"}});
}
}  // namespace

Scene kidneyDemo(const std::stop_token& stop) {
  const Tubes artery = arteryTubes();
  const Tubes vein = veinTubes();
  const Tubes ureter = ureterTubes();
  constexpr float blend = 3.0f;
  // Vessels keep clear of each other and of the kidney by a hair, so no two structures overlap.
  constexpr float gap = 0.6f;
  // All the others ask the artery.
  const Field arteryField =
      stoppable([&](const glm::vec3& p) { return branched(artery, p, blend); }, stop);
  const Field veinField = [&](const glm::vec3& p) {
    return blendedDifference(branched(vein, p, blend), arteryField(p) - gap, 1.0f);
  };
  const Field ureterField = [&](const glm::vec3& p) {
    const float vessels = std::min(arteryField(p), veinField(p)) - gap;
    return blendedDifference(branched(ureter, p, blend), vessels, 1.0f);
  };
  const Field kidney = [&](const glm::vec3& p) {
    const float entering = std::min({arteryField(p), veinField(p), ureterField(p)}) - gap;
    return blendedDifference(kidneyField(p), entering, 2.0f);
  };

  Scene scene;
  const NodeId organs = addGroup(scene, "Urinary organs");
  const NodeId vessels = addGroup(scene, "Vessels");
  addStructure(scene, organs, "left kidney",
               polygonise(kidney, {{-58, -34, -72}, {40, 34, 66}}, 1.1f),
               {.colour = {158, 79, 62}, .gamma = 4.0f});
  addStructure(scene, organs, "left ureter", polygonise(ureterField, around(ureter, 3.0f), 0.7f),
               {.colour = {226, 190, 92}, .gamma = 5.0f});
  addStructure(scene, vessels, "left renal artery",
               polygonise(arteryField, around(artery, 3.0f), 0.6f),
               {.colour = {204, 44, 40}, .gamma = 5.0f});
  addStructure(scene, vessels, "left renal vein", polygonise(veinField, around(vein, 3.0f), 0.7f),
               {.colour = {58, 98, 178}, .gamma = 5.0f});
  return scene;
}

}  // namespace sline::model
