// SPDX-License-Identifier: Apache-2.0
// Models the lumbar column with the last thoracic vertebra and its ribs, and the psoas muscles
// beside it. One vertebra is modelled and set up six times, growing downwards and tilted along the
// lordosis.
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "model/demo/abdomen/parts.h"
#include "model/sculpting/swept.h"

namespace sline::model {

namespace {
constexpr Colour boneColour{248, 234, 214};
constexpr Colour discColour{169, 199, 214};
constexpr Colour muscleColour{100, 42, 36};

/// Says where a vertebral body stands: its middle, the tilt of its upper face to the front
/// (radians) and its size relative to the third lumbar vertebra.
struct Level {
  const char* name;
  glm::vec3 middle;
  float tilt;
  float size;
  float transverse;  ///< length of its transverse processes, mm
  float stoutness;   ///< their thickness relative to the third lumbar vertebra's
};
constexpr std::array<Level, 6> levels{{{"T12 vertebra", {0, 24, 49}, -0.10f, 0.88f, 12, 0.9f},
                                       {"L1 vertebra", {0, 20, 14}, -0.08f, 0.93f, 20, 0.95f},
                                       {"L2 vertebra", {0, 17, -23}, -0.04f, 0.97f, 25, 1.0f},
                                       {"L3 vertebra", {0, 15, -61}, 0.03f, 1.0f, 29, 1.0f},
                                       {"L4 vertebra", {0, 17, -99}, 0.13f, 1.02f, 25, 1.05f},
                                       {"L5 vertebra", {0, 24, -136}, 0.30f, 1.04f, 23, 1.45f}}};
constexpr float bodyHalfHeight = 13.6f;

/// Converts a point into the frame of a vertebra the size of the third lumbar: middle of its body,
/// z up.
glm::vec3 intoLevel(const Level& level, const glm::vec3& p) {
  const glm::vec3 d = (p - level.middle) / level.size;
  const float c = std::cos(level.tilt);
  const float s = std::sin(level.tilt);
  return {d.x, c * d.y - s * d.z, s * d.y + c * d.z};
}

glm::vec3 outOfLevel(const Level& level, const glm::vec3& q) {
  const float c = std::cos(level.tilt);
  const float s = std::sin(level.tilt);
  return level.middle + level.size * glm::vec3(q.x, c * q.y + s * q.z, -s * q.y + c * q.z);
}

/// Returns the distance to the kidney-shaped outline of body and disc in the horizontal plane.
float outline(const glm::vec2& p, float halfWidth, float halfDepth) {
  const glm::vec2 a(halfWidth, halfDepth);
  const float k0 = glm::length(p / a);
  const float k1 = glm::length(p / (a * a));
  const float oval = k1 > 1e-6f ? k0 * (k0 - 1.0f) / k1 : -halfDepth;
  const float canal = glm::length(p - glm::vec2(0, halfDepth + 12.0f)) - 14.5f;
  return blendedDifference(oval, canal, 4.0f);
}

/// Holds the processes of the left side; the right ones are their mirror image. The foramen between
/// them is a triangle, wider than deep. The articular facets stand obliquely: the superior ones are
/// turned back and to the middle, the inferior ones forward and outwards.
struct Arch {
  Arch(float transverseLength, float stoutness)
      : pedicle(std::array<SweptPoint, 3>{{{{13, 10, 5}, 5.2f, 1.4f},
                                           {{15.2f, 18, 4.5f}, 4.4f, 1.6f},
                                           {{15.5f, 25, 2}, 5.0f, 1.5f}}},
                {0, 0, 1}),
        lamina(std::array<SweptPoint, 3>{{{{15, 25, -1}, 4.4f, 1.9f},
                                          {{8.5f, 32, -6}, 3.6f, 3.0f},
                                          {{0, 38, -8}, 3.4f, 3.1f}}},
               {0, 0, 1}),
        transverse(
            std::array<SweptPoint, 4>{
                {{{14, 24, 2}, 5.0f * stoutness, 1.3f},
                 {{17.0f + 0.4f * transverseLength, 27, 3}, 3.3f * stoutness, 1.9f},
                 {{17.0f + 0.8f * transverseLength, 30, 4.5f}, 2.7f * stoutness, 2.3f},
                 {{17.5f + transverseLength, 32, 5}, 2.5f * stoutness, 2.1f}}},
            {0, 0, 1}),
        superior(std::array<SweptPoint, 3>{{{{16, 25, 1}, 4.8f, 1.3f},
                                            {{17.5f, 26, 10}, 4.8f, 1.9f},
                                            {{18, 27.5f, 18}, 4.0f, 1.9f}}},
                 facet),
        inferior(std::array<SweptPoint, 3>{{{{10.5f, 31, -6}, 4.4f, 1.5f},
                                            {{11, 33.5f, -15}, 4.2f, 1.8f},
                                            {{11.5f, 34, -22}, 3.7f, 1.8f}}},
                 facet) {}

  float distance(const glm::vec3& q) const {
    const glm::vec3 m(std::abs(q.x), q.y, q.z);
    float d = blendedUnion(pedicle.distance(m), lamina.distance(m), 5.0f);
    d = blendedUnion(d, transverse.distance(m), 5.0f);
    d = blendedUnion(d, superior.distance(m), 5.0f);
    d = blendedUnion(d, inferior.distance(m), 5.0f);
    return blendedUnion(d, spinous(q), 6.0f);
  }

  /// Returns the distance to the spinous process: an upright plate like a hatchet's blade, with a
  /// thicker rim behind.
  static float spinous(const glm::vec3& q) {
    constexpr glm::vec2 half(16, 11);
    constexpr float corner = 5.0f;
    const glm::vec2 at(q.y - 49.0f, q.z + 10.0f + 0.22f * (q.y - 49.0f));
    const glm::vec2 out = glm::abs(at) - half + corner;
    const float outline = glm::length(glm::max(out, glm::vec2(0.0f))) +
                          std::min(std::max(out.x, out.y), 0.0f) - corner;
    const float thickness = 2.7f + 1.7f * glm::smoothstep(3.0f, 15.0f, at.x);
    return blendedIntersection(outline, std::abs(q.x) - thickness, 3.5f);
  }

  static constexpr glm::vec3 facet{0.7f, 0.7f, 0.0f};  ///< along the facets' breadth
  Swept pedicle, lamina, transverse, superior, inferior;
};

float bodyField(const glm::vec3& q) {
  const float height = q.z / bodyHalfHeight;
  const float waist = 2.6f * (1.0f - std::min(height * height, 1.0f));
  const float wall = outline({q.x, q.y}, 25.0f - waist, 17.5f - waist);
  // The end plates are slightly hollow within their rims.
  const float plate = 1.4f * std::exp(-0.5f * (q.x * q.x / 130.0f + q.y * q.y / 60.0f));
  return blendedIntersection(wall, std::abs(q.z) - bodyHalfHeight + plate, 4.0f);
}

DemoStructure vertebra(const Level& level) {
  const auto arch = std::make_shared<Arch>(level.transverse, level.stoutness);
  DemoStructure s{
      .name = level.name, .groups = {"Bones"}, .colour = boneColour, .gamma = Gamma::clamped(1.3f)};
  s.field = [level, arch](const glm::vec3& p) {
    const glm::vec3 q = intoLevel(level, p);
    return level.size * blendedUnion(bodyField(q), arch->distance(q), 5.0f);
  };
  for (const float x : {-54.0f, 54.0f})
    for (const float y : {-22.0f, 84.0f})
      for (const float z : {-34.0f, 28.0f})
        s.box.add(outOfLevel(level, {x, y, z}));
  s.edge = 2.0f;
  s.gap = 0.6f;
  s.smoothing = 1.1f;
  return s;
}

DemoStructure disc(const Level& above, const Level& below) {
  const glm::vec3 top = outOfLevel(above, {0, 0, -bodyHalfHeight});
  const glm::vec3 bottom = outOfLevel(below, {0, 0, bodyHalfHeight});
  const Level middle{.middle = 0.5f * (top + bottom),
                     .tilt = 0.5f * (above.tilt + below.tilt),
                     .size = 0.5f * (above.size + below.size)};
  const std::string from(above.name, std::string_view(above.name).find(' '));
  const std::string to(below.name, std::string_view(below.name).find(' '));
  DemoStructure s{.name = from + "-" + to + " intervertebral disc",
                  .groups = {"Discs and cartilage"},
                  .colour = discColour,
                  .gamma = Gamma::clamped(1.3f)};
  s.field = [middle](const glm::vec3& p) {
    const glm::vec3 q = intoLevel(middle, p);
    const float bulge = 0.9f * (1.0f - std::min(q.z * q.z / 36.0f, 1.0f));
    const float wall = outline({q.x, q.y}, 23.6f + bulge, 16.2f + bulge);
    return middle.size * blendedIntersection(wall, std::abs(q.z) - 8.0f, 5.0f);
  };
  s.box = {middle.middle - glm::vec3(30, 25, 17), middle.middle + glm::vec3(30, 25, 17)};
  s.edge = 2.0f;
  s.gap = 0.5f;
  s.rounding = 1.8f;
  s.smoothing = 1.0f;
  return s;
}

DemoStructure swept(std::string name, const char* group, Colour colour,
                    const std::shared_ptr<const Swept>& shape) {
  return {.name = std::move(name),
          .groups = {group},
          .colour = colour,
          .gamma = Gamma::clamped(1.3f),
          .field = [shape](const glm::vec3& p) { return shape->distance(p); },
          .box = grown(shape->bounds(), 3.0f)};
}

template <std::size_t N>
std::array<SweptPoint, N> onSide(std::array<SweptPoint, N> points, float side) {
  for (SweptPoint& p : points)
    p.position.x *= side;
  return points;
}

DemoStructure rib(const char* name, float side) {
  // The rib is a blade, higher than thick, that points down and forward to the loin.
  const auto shape = std::make_shared<Swept>(onSide<6>({{{{23, 41, 52}, 3.4f, 1.3f},
                                                         {{35, 56, 50}, 2.9f, 1.9f},
                                                         {{50, 68, 44}, 2.6f, 2.4f},
                                                         {{66, 74, 34}, 2.4f, 2.6f},
                                                         {{81, 75, 23}, 2.2f, 2.3f},
                                                         {{92, 71, 14}, 1.8f, 1.8f}}},
                                                       side),
                                             glm::vec3(0, 0, 1));
  DemoStructure s = swept(name, "Bones", boneColour, shape);
  s.edge = 1.6f;
  s.smoothing = 1.0f;
  return s;
}

DemoStructure psoas(const char* name, float side) {
  const auto shape = std::make_shared<Swept>(onSide<7>({{{{29, 22, 18}, 6.0f, 1.2f},
                                                         {{35, 20, -20}, 12.0f, 1.2f},
                                                         {{43, 16, -66}, 18.0f, 1.15f},
                                                         {{54, 12, -112}, 22.0f, 1.0f},
                                                         {{66, 2, -160}, 21.0f, 0.95f},
                                                         {{79, -26, -222}, 16.5f, 0.95f},
                                                         {{83, -36, -246}, 15.0f, 0.95f}}},
                                                       side),
                                             glm::vec3(0, -1, 0));
  DemoStructure s = swept(name, "Muscles", muscleColour, shape);
  s.gamma = Gamma::clamped(1.4f);
  s.field = [shape](const glm::vec3& p) {
    // Bundles of fibres run along the muscle.
    const SweptCoordinates at = shape->place(p);
    const float bundles = std::sin(7.0f * at.angle + 0.9f * std::sin(at.along / 40.0f));
    return at.distance + 0.35f * bundles * std::min(at.radius / 12.0f, 1.0f);
  };
  s.edge = 2.6f;
  s.gap = 0.8f;
  s.rounding = 3.0f;
  s.smoothing = 2.0f;
  return s;
}
}  // namespace

std::vector<DemoStructure> abdomenBones() {
  std::vector<DemoStructure> bones;
  bones.reserve(2 * levels.size() + 1);  // a disc between each two vertebrae, and two ribs
  for (const Level& level : levels)
    bones.push_back(vertebra(level));
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    bones.push_back(disc(levels[i], levels[i + 1]));
  bones.push_back(rib("right twelfth rib", -1.0f));
  bones.push_back(rib("left twelfth rib", 1.0f));
  return bones;
}

std::vector<DemoStructure> abdomenMuscles() {
  return {psoas("right psoas major", -1.0f), psoas("left psoas major", 1.0f)};
}

}  // namespace sline::model
