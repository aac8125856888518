// SPDX-License-Identifier: Apache-2.0
// Models liver, gallbladder and bile ducts, pancreas, spleen and adrenal glands.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/demo/abdomen/parts.h"
#include "model/sculpting/lamina.h"
#include "model/sculpting/swept.h"

namespace sline::model {

namespace {
constexpr Colour liverColour{138, 69, 38};
constexpr Colour bileColour{60, 130, 90};
constexpr Colour pancreasColour{216, 180, 94};
constexpr Colour spleenColour{125, 74, 115};
constexpr Colour adrenalColour{224, 176, 60};

struct GlandStyle {
  const char* group;
  Colour colour;
  float gamma;
};

DemoStructure gland(std::string name, const GlandStyle& look, Field field, const Box& box) {
  return {.name = std::move(name),
          .groups = {look.group},
          .colour = look.colour,
          .gamma = Gamma::clamped(look.gamma),
          .field = std::move(field),
          .box = box};
}

DemoStructure liver() {
  DemoStructure s = gland("liver", {"Digestive system", liverColour, 4.3f}, liverField(),
                          {{-150, -104, -75}, {96, 88, 122}});
  s.edge = 2.4f;
  s.rounding = 7.0f;
  s.gap = 1.7f;
  s.smoothing = 3.0f;
  return s;
}

std::shared_ptr<const Swept> gallbladderTube() {
  return std::make_shared<Swept>(std::array<SweptPoint, 8>{{{{-77, -84, -33}, 13.2f},
                                                            {{-76, -76, -26}, 15.3f},
                                                            {{-73, -65, -14}, 15.2f},
                                                            {{-67, -52, 3}, 11.5f},
                                                            {{-59, -42, 16}, 7.5f},
                                                            {{-52, -36, 23}, 4.6f},
                                                            {{-45, -31, 25.5f}, 2.8f},
                                                            {{-38, -28, 21}, 2.3f}}},
                                 glm::vec3(0, -1, 0));
}

DemoStructure gallbladder() {
  const auto tube = gallbladderTube();
  const Field field = [tube](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    // The spiral fold twists the neck.
    const float neck = std::clamp((at.along - 58.0f) / 10.0f, 0.0f, 1.0f);
    return at.distance + neck * 0.4f * std::sin(at.along * 1.25f + at.angle);
  };
  DemoStructure s = gland("gallbladder", {"Biliary system", bileColour, 4.5f}, field,
                          grown(tube->bounds(), 3.0f));
  s.edge = 1.6f;
  s.smoothing = 1.0f;
  s.wall = 2.0f;
  return s;
}

DemoStructure bileDucts() {
  const auto common = std::make_shared<Swept>(std::array<SweptPoint, 8>{{{{-36, -27, 44}, 2.6f},
                                                                         {{-34, -26, 34}, 3.1f},
                                                                         {{-34, -25.5f, 20}, 3.3f},
                                                                         {{-35, -24, 6}, 3.5f},
                                                                         {{-37, -20, -8}, 3.4f},
                                                                         {{-41, -15, -22}, 3.2f},
                                                                         {{-45, -12, -31}, 3.0f},
                                                                         {{-50, -11, -36}, 2.6f}}},
                                              glm::vec3(0, -1, 0));
  const auto right = std::make_shared<Swept>(
      std::array<SweptPoint, 3>{
          {{{-35, -26, 34}, 2.4f}, {{-44, -26, 42}, 2.3f}, {{-56, -24, 47}, 1.9f}}},
      glm::vec3(0, -1, 0));
  const auto left = std::make_shared<Swept>(
      std::array<SweptPoint, 3>{
          {{{-34, -26, 34}, 2.4f}, {{-27, -28, 43}, 2.3f}, {{-14, -31, 50}, 1.9f}}},
      glm::vec3(0, -1, 0));
  const auto cystic = std::make_shared<Swept>(
      std::array<SweptPoint, 3>{
          {{{-38, -28, 21}, 2.2f}, {{-36, -26.5f, 17}, 2.2f}, {{-34.5f, -25.5f, 10}, 2.6f}}},
      glm::vec3(0, -1, 0));
  const Field field = [=](const glm::vec3& p) {
    float d = blendedUnion(common->distance(p), right->distance(p), 2.5f);
    d = blendedUnion(d, left->distance(p), 2.5f);
    return blendedUnion(d, cystic->distance(p), 2.0f);
  };
  Box box = common->bounds();
  for (const auto& branch : {right, left, cystic})
    box.add(branch->bounds());
  DemoStructure s =
      gland("bile duct", {"Biliary system", bileColour, 4.5f}, field, grown(box, 3.0f));
  s.edge = 1.0f;
  s.gap = 0.3f;
  s.smoothing = 0.6f;
  s.wall = 0.8f;
  return s;
}

/// Returns the height of the lobules: hills and furrows some 7 mm wide.
float lobules(const glm::vec3& p) {
  const glm::vec3 q = 0.50f * p + 0.9f * glm::vec3(std::sin(0.21f * p.z + 1.0f),
                                                   std::sin(0.19f * p.x), std::sin(0.23f * p.y));
  return std::sin(q.x) * std::sin(q.y + 0.7f) + std::sin(q.y) * std::sin(q.z + 1.9f) +
         std::sin(q.z) * std::sin(q.x + 0.4f);
}

DemoStructure pancreas() {
  const auto body =
      std::make_shared<Swept>(std::array<SweptPoint, 9>{{{{-35, -27, -40}, 15, 0.80f},
                                                         {{-34, -29, -22}, 17, 0.75f},
                                                         {{-25, -37, -9}, 14, 0.75f},
                                                         {{-7, -47, -2}, 9.5f, 0.80f},
                                                         {{12, -45, 4}, 11, 0.75f},
                                                         {{34, -25, 10}, 12.5f, 0.70f},
                                                         {{58, -3, 17}, 12, 0.70f},
                                                         {{80, 12, 26}, 10.5f, 0.75f},
                                                         {{97, 20, 34}, 7.5f, 0.85f}}},
                              glm::vec3(0, -1, 0));
  const auto uncinate =
      std::make_shared<Swept>(std::array<SweptPoint, 3>{{{{-33, -26, -44}, 12, 0.8f},
                                                         {{-20, -26, -49}, 9.5f, 0.8f},
                                                         {{-7, -28, -50}, 5.5f, 0.8f}}},
                              glm::vec3(0, -1, 0));
  const Field field = [=](const glm::vec3& p) {
    const float d = blendedUnion(body->distance(p), uncinate->distance(p), 8.0f);
    return d > 6.0f ? d - 2.0f : d + 0.40f * lobules(p);
  };
  Box box = body->bounds();
  box.add(uncinate->bounds());
  DemoStructure s =
      gland("pancreas", {"Digestive system", pancreasColour, 4.5f}, field, grown(box, 4.0f));
  s.edge = 1.7f;
  s.rounding = 2.0f;
  s.smoothing = 1.3f;
  return s;
}

/// Returns the directions of the spleen's length, width and thickness as columns. It lies along the
/// tenth rib.
glm::mat3 spleenAxes() {
  const glm::vec3 length = glm::normalize(glm::vec3(0.30f, -0.75f, -0.45f));
  const glm::vec3 outward = glm::normalize(glm::vec3(0.80f, 0.60f, 0.0f));
  const glm::vec3 thickness = glm::normalize(outward - glm::dot(outward, length) * length);
  return {length, glm::cross(thickness, length), thickness};
}

DemoStructure spleen() {
  const glm::vec3 middle(103, 38, 69);
  const glm::mat3 axes = spleenAxes();
  const Field field = [=](const glm::vec3& p) {
    // In the spleen's frame x runs along its length (down and forward), y across (down and back), z
    // out towards the ribs.
    const glm::vec3 q = (p - middle) * axes;
    glm::vec3 bent = q;
    bent.z += 0.0045f * q.x * q.x + 0.0060f * q.y * q.y;
    float d = ellipsoid(bent, {58.0f, 37.0f, 19.0f});
    // The gastric and renal faces are hollow; the hilum is a groove on the ridge between them.
    const float gastric = glm::length(q - glm::vec3(4, -30, -74)) - 64.0f;
    const float renal = glm::length(q - glm::vec3(-8, 36, -72)) - 60.0f;
    d = blendedDifference(d, gastric, 9.0f);
    d = blendedDifference(d, renal, 9.0f);
    d = blendedDifference(d, ellipsoid(q - glm::vec3(0, 1, -17), {26.0f, 4.0f, 7.0f}), 4.0f);
    // The upper border has notches.
    for (const auto& [along, size] : {std::pair{10.0f, 2.6f}, {25.0f, 4.4f}, {38.0f, 2.2f}}) {
      const glm::vec3 n = q - glm::vec3(along, 0.011f * along * along - 41.0f, -8.0f);
      d = blendedDifference(d, ellipsoid(n, {size * 0.7f, 2.6f * size, 22.0f}), 5.0f);
    }
    return d;
  };
  DemoStructure s = gland("spleen", {"Glands and spleen", spleenColour, 4.3f}, field,
                          {{40, -34, 4}, {162, 112, 132}});
  s.edge = 2.0f;
  s.rounding = 4.0f;
  s.smoothing = 1.8f;
  return s;
}

/// Models a gland on the kidney's upper pole: two thin leaves that meet in a crest in front and
/// part towards the back. `leaves` run from the lateral edge over the crest to the medial edge,
/// five places a row, from above down; x is lateral, y to the back.
DemoStructure adrenal(const char* name, const glm::vec3& middle, float side,
                      std::span<const glm::vec3> leaves) {
  constexpr std::size_t columns = 5;
  std::vector<LaminaPoint> points;
  points.reserve(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
    points.push_back({middle + glm::vec3(side, 1, 1) * leaves[i], i % columns == 2 ? 2.7f : 2.0f});
  const auto sheet = std::make_shared<const Lamina>(points, columns);
  DemoStructure s = gland(
      name, {"Glands and spleen", adrenalColour, 4.0f},
      [sheet](const glm::vec3& p) { return sheet->distance(p); }, grown(sheet->bounds(), 3.0f));
  s.edge = 1.3f;
  s.smoothing = 1.2f;
  return s;
}

/// The right gland is a pyramid behind the vena cava.
DemoStructure rightAdrenal() {
  static constexpr std::array<glm::vec3, 20> leaves{
      {{3, 5, 15},    {2, 2.5f, 16},  {0.5f, 0, 16}, {-1, 2.5f, 15}, {-2, 5, 14},
       {7, 9, 5},     {4, 3, 6},      {0, -3, 6},    {-3, 3, 5},     {-4.5f, 9, 4},
       {11, 12, -4},  {6, 4, -4},     {0, -6, -4},   {-4, 4, -4},    {-6, 12, -4},
       {15, 12, -12}, {8, 4.5f, -13}, {1, -7, -14},  {-4, 4, -13},   {-7, 12, -12}}};
  return adrenal("right adrenal gland", {-38, 20, 42}, -1.0f, leaves);
}

/// The left gland is a crescent along the kidney's upper pole and medial border.
DemoStructure leftAdrenal() {
  static constexpr std::array<glm::vec3, 20> leaves{
      {{6, 8, 15},   {4, 4, 16},   {2, 0, 16},    {0, 4, 15},   {-1, 8, 14},
       {10, 12, 4},  {5, 4, 4},    {-1, -5, 5},   {-4, 4, 4},   {-6, 11, 3},
       {9, 13, -9},  {4, 4, -9},   {-4, -8, -8},  {-7, 3, -9},  {-9, 11, -9},
       {3, 10, -19}, {-1, 2, -20}, {-7, -6, -20}, {-9, 1, -20}, {-10, 8, -19}}};
  return adrenal("left adrenal gland", {40, 20, 50}, 1.0f, leaves);
}
}  // namespace

std::vector<DemoStructure> abdomenGlands() {
  return {gallbladder(), bileDucts(), rightAdrenal(), leftAdrenal(), pancreas()};
}

std::vector<DemoStructure> abdomenSpleenAndLiver() {
  return {spleen(), liver()};
}

}  // namespace sline::model
