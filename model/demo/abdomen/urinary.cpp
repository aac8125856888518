// SPDX-License-Identifier: Apache-2.0
// Models the kidneys (the bean of the kidney demo, set against the psoas) and the ureters.
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <memory>
#include <string>
#include <utility>

#include "model/demo/abdomen/parts.h"
#include "model/demo/kidney/kidney.h"
#include "model/sculpting/swept.h"

namespace sline::model {

namespace {
constexpr Colour kidneyColour{168, 87, 60};
constexpr Colour ureterColour{216, 155, 84};

DemoStructure kidney(const char* name, float side, const glm::vec3& middle) {
  // The kidney's upper pole leans to the midline and back, and its hilum turns forward.
  const glm::vec3 up = glm::normalize(glm::vec3(-0.22f, 0.20f, 1.0f));
  const glm::vec3 lateral = glm::normalize(glm::vec3(0.86f, 0.50f, 0.1f));
  const glm::vec3 x = glm::normalize(lateral - glm::dot(lateral, up) * up);
  const glm::mat3 axes(x, glm::cross(up, x), up);
  const Field field = [=](const glm::vec3& p) {
    glm::vec3 d = p - middle;
    d.x *= side;
    return kidneyField(d * axes);
  };
  DemoStructure s{.name = name,
                  .groups = {"Urinary system"},
                  .colour = kidneyColour,
                  .gamma = Gamma::clamped(4.3f),
                  .field = field,
                  .box = {middle - glm::vec3(52, 48, 72), middle + glm::vec3(52, 48, 70)}};
  s.edge = 2.0f;
  s.gap = 0.9f;
  s.rounding = 2.5f;
  s.smoothing = 1.5f;
  return s;
}

DemoStructure ureter(const char* name, float side, float drop) {
  const auto place = [=](float x, float y, float z) { return glm::vec3(side * x, y, z + drop); };
  const auto tube =
      std::make_shared<Swept>(std::array<SweptPoint, 10>{{{place(57, 33, 12), 2.6f},
                                                          {place(46, 31, 3), 5.0f},
                                                          {place(38, 26, -10), 4.2f},
                                                          {place(36, 11, -30), 2.5f},
                                                          {place(38, -9, -58), 2.3f},
                                                          {place(41, -14, -100), 2.4f},
                                                          {{side * 40, -23, -150}, 2.3f},
                                                          {{side * 34, -16, -184}, 2.4f},
                                                          {{side * 31, 10, -214}, 2.4f},
                                                          {{side * 32, 20, -244}, 2.4f}}},
                              glm::vec3(0, -1, 0));
  const auto calyx = std::make_shared<Swept>(
      std::array<SweptPoint, 3>{
          {{place(57, 33, -14), 2.4f}, {place(48, 30, -9), 4.0f}, {place(40, 27, -8), 4.2f}}},
      glm::vec3(0, -1, 0));
  Box box = tube->bounds();
  box.add(calyx->bounds());
  DemoStructure s{.name = name,
                  .groups = {"Urinary system"},
                  .colour = ureterColour,
                  .gamma = Gamma::clamped(4.3f),
                  .field =
                      [tube, calyx](const glm::vec3& p) {
                        return blendedUnion(tube->distance(p), calyx->distance(p), 3.0f);
                      },
                  .box = grown(box, 3.0f)};
  s.edge = 1.1f;
  s.smoothing = 0.8f;
  s.wall = 0.8f;
  return s;
}
}  // namespace

std::vector<DemoStructure> abdomenUrinary() {
  return {ureter("right ureter", -1.0f, -16.0f), ureter("left ureter", 1.0f, 0.0f),
          kidney("right kidney", -1.0f, {-65, 38, -14}), kidney("left kidney", 1.0f, {65, 36, 2})};
}

}  // namespace sline::model
