// SPDX-License-Identifier: Apache-2.0
// Models a kidney with measures from common anatomy textbooks: it has 11 × 5.5 × 4 cm, and its
// hilum faces medially and a little to the front; the vein lies in front of the artery, the renal
// pelvis behind both.
#include "model/demo/kidney/kidney.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "model/sculpting/demo_structure.h"
#include "model/sculpting/implicit.h"

namespace sline::model {

/// Returns the field of a bean: an ellipsoid bent around the hilum, fuller towards its poles, the
/// upper one broader, with a slit between two lips that opens into the sinus.
float kidneyField(const glm::vec3& p) {
  glm::vec3 q = p;
  q.x += 0.0052f * q.z * q.z - 2.0f;
  q.x += 0.10f * q.y;
  const float broad = 1.0f + 0.0016f * q.z;
  const float d = cushion(q / glm::vec3(broad, broad, 1.0f), {27.0f, 20.0f, 55.0f}, 0.3f) * broad;
  const float slit = ellipsoid(p - glm::vec3(-27, -3, 0), {16.0f, 8.0f, 18.0f});
  const float sinus = ellipsoid(p - glm::vec3(-13, 0, 0), {12.0f, 10.0f, 21.0f});
  return blendedDifference(d, blendedUnion(slit, sinus, 6.0f), 5.0f);
}

namespace {
using Tubes = std::vector<Tube>;

/// Returns the distance to the branches of one vessel, blended where they part.
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

/// Returns the renal pelvis, which gathers two calyces and narrows into the ureter.
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
  return grown(box, margin);
}

/// Makes branching tubes with a thin wall, with a mesh fine enough for the smaller branches.
DemoStructure vessel(const char* name, const char* group, Colour colour, const Tubes& tubes) {
  // Vessels and ureter continue beyond the scene and end in a clean cut.
  constexpr float cutX = -58.0f;
  constexpr float cutZ = -106.0f;
  DemoStructure s{
      .name = name,
      .groups = {group},
      .colour = colour,
      .field =
          [tubes](const glm::vec3& p) {
            const float cut = std::max(cutX - p.x, cutZ - p.z);
            return -blendedUnion(-branched(tubes, p, 3.0f), -cut, 0.8f);
          },
      .box = around(tubes, 3.0f),
  };
  s.edge = 0.65f;
  // Vessels keep a small distance from each other and from the kidney, so no two structures
  // overlap.
  s.gap = 0.6f;
  s.smoothing = 0.5f;
  s.wall = 0.7f;
  return s;
}

/// Returns the structures; earlier ones keep their shape.
std::vector<DemoStructure> kidneyStructures() {
  DemoStructure kidney{.name = "left kidney",
                       .groups = {"Urinary organs"},
                       .colour = {158, 79, 62},
                       .field = kidneyField,
                       .box = {{-58, -34, -72}, {44, 34, 68}}};
  kidney.edge = 1.1f;
  kidney.gap = 1.0f;
  kidney.rounding = 2.0f;
  kidney.smoothing = 1.3f;
  DemoStructure artery = vessel("left renal artery", "Vessels", {204, 44, 40}, arteryTubes());
  DemoStructure vein = vessel("left renal vein", "Vessels", {58, 98, 178}, veinTubes());
  DemoStructure ureter = vessel("left ureter", "Urinary organs", {226, 190, 92}, ureterTubes());
  vein.givesWayTo = {artery.name};
  ureter.givesWayTo = {artery.name, vein.name};
  kidney.givesWayTo = {artery.name, vein.name, ureter.name};
  kidney.gamma = Gamma::clamped(4.3f);
  ureter.gamma = Gamma::clamped(4.5f);
  artery.gamma = Gamma::clamped(3.0f);
  vein.gamma = Gamma::clamped(3.0f);
  artery.inkColour = arteryInk;
  vein.inkColour = veinInk;
  std::vector<DemoStructure> all{kidney, ureter, artery, vein};
  for (DemoStructure& s : all)
    s.fill = Fill::paper;
  return all;
}
}  // namespace

Scene kidneyDemo(const std::stop_token& stop) {
  return demoScene(kidneyStructures(), stop);
}

}  // namespace sline::model
