// SPDX-License-Identifier: Apache-2.0
// Models aorta, inferior vena cava and the portal system: trees of tubes, blended where they
// branch.
#include <algorithm>
#include <glm/common.hpp>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "model/demo/abdomen/parts.h"
#include "model/sculpting/swept.h"

namespace sline::model {

namespace {
constexpr Colour arteryColour{207, 34, 20};
constexpr Colour veinColour{44, 84, 166};
constexpr Colour portalColour{152, 132, 230};

using Course = std::vector<SweptPoint>;
using SweptTubes = std::vector<Swept>;

struct Kind {
  const char* group;
  Colour colour;
  Colour ink;
  float wall;  ///< thickness in mm
};
constexpr Kind arterial{"Arteries", arteryColour, arteryInk, 1.4f};
constexpr Kind venous{"Veins", veinColour, veinInk, 1.0f};
constexpr Kind ofPortal{"Portal system", portalColour, portalInk, 1.0f};

DemoStructure vessel(std::string name, const Kind& kind, Field field, const Box& box) {
  DemoStructure s{.name = std::move(name),
                  .groups = {kind.group},
                  .colour = kind.colour,
                  .gamma = Gamma::clamped(3.0f),
                  .inkColour = kind.ink,
                  .field = std::move(field),
                  .box = grown(box, 3.0f)};
  s.gap = 0.4f;
  s.wall = kind.wall;
  return s;
}

std::shared_ptr<const SweptTubes> tubesAlong(const std::vector<Course>& courses) {
  auto tubes = std::make_shared<SweptTubes>();
  for (const Course& course : courses)
    tubes->emplace_back(course, glm::vec3(0.31f, -0.9f, 0.3f), 1.5f);
  return tubes;
}

float thinnest(const std::vector<Course>& courses) {
  float radius = 100.0f;
  for (const Course& course : courses)
    for (const SweptPoint& p : course)
      radius = std::min(radius, p.radius);
  return radius;
}

Box boundsOf(const SweptTubes& tubes) {
  Box box;
  for (const Swept& tube : tubes)
    box.add(tube.bounds());
  return box;
}

float blended(const SweptTubes& tubes, const glm::vec3& p, float blend) {
  float d = tubes.front().distance(p);
  for (std::size_t i = 1; i < tubes.size(); ++i)
    d = blendedUnion(d, tubes[i].distance(p), blend);
  return d;
}

/// Returns edges short enough for the thinnest branch to be round.
float edgeFor(float radius) {
  return std::clamp(0.5f * radius, 0.9f, 2.0f);
}

DemoStructure vessel(std::string name, const Kind& kind, const std::vector<Course>& courses) {
  const auto tubes = tubesAlong(courses);
  const float radius = thinnest(courses);
  const float blend = std::min(8.0f, 1.6f * radius);
  DemoStructure s = vessel(
      std::move(name), kind, [=](const glm::vec3& p) { return blended(*tubes, p, blend); },
      boundsOf(*tubes));
  s.edge = edgeFor(radius);
  s.smoothing = std::clamp(0.35f * radius, 0.6f, 1.2f);
  return s;
}

/// Describes a branch of a vessel. Vessel and branches form one smooth tree, which is cut across
/// each branch at a place on its centre line, so walls continue from one to the other without a
/// step.
struct Branch {
  std::string name;
  std::vector<Course> courses;  ///< the first begins within the trunk
  glm::vec3 from;               ///< place on the first course where the branch's own body begins
};

std::vector<DemoStructure> vesselTree(std::string trunk, const Kind& kind,
                                      const std::vector<Course>& courses,
                                      const std::vector<Branch>& branches) {
  constexpr float blend = 9.0f;
  std::vector<Course> all = courses;
  for (const Branch& branch : branches)
    all.insert(all.end(), branch.courses.begin(), branch.courses.end());
  const auto tubes = tubesAlong(all);
  const Field tree = [=](const glm::vec3& p) { return blended(*tubes, p, blend); };

  std::vector<DemoStructure> made{vessel(std::move(trunk), kind, tree, {})};
  Field rest = tree;
  std::size_t first = courses.size();
  for (const Branch& branch : branches) {
    // The branch owns the part of the tree that lies beyond the cut and close enough to it.
    const std::size_t last = first + branch.courses.size();
    const float along = (*tubes)[first].alongNearest(branch.from);
    const Field own = [=](const glm::vec3& p) {
      const SweptCoordinates at = (*tubes)[first].place(p);
      float near = at.distance;
      for (std::size_t i = first + 1; i < last; ++i)
        near = std::min(near, (*tubes)[i].distance(p));
      // A side branch that has left the first course is past the cut.
      constexpr float left = 12.0f;
      return at.distance > left ? near - 3.0f
                                : std::max(near - 3.0f, -(*tubes)[first].beyond(along, p, at));
    };
    Box box;
    for (std::size_t i = first; i < last; ++i)
      box.add((*tubes)[i].bounds());
    DemoStructure part = vessel(
        branch.name, kind,
        [=](const glm::vec3& p) {
          const float d = own(p);
          return d > 5.0f ? d : -blendedUnion(-tree(p), -d, 0.6f);
        },
        box);
    part.edge = edgeFor(thinnest(branch.courses));
    made.push_back(std::move(part));
    rest = [rest, own](const glm::vec3& p) {
      const float d = rest(p);
      return d > 5.0f ? d : blendedDifference(d, own(p), 0.6f);
    };
    first = last;
  }
  made.front().field = rest;
  made.front().box = grown(boundsOf(*tubes), 3.0f);
  made.front().edge = edgeFor(thinnest(courses));
  return made;
}

DemoStructure artery(std::string name, const std::vector<Course>& courses) {
  return vessel(std::move(name), arterial, courses);
}

DemoStructure vein(std::string name, const std::vector<Course>& courses) {
  return vessel(std::move(name), venous, courses);
}

/// Models the aorta, which divides in front of the fourth lumbar vertebra into the common iliac
/// arteries; each of these divides before the sacroiliac joint.
std::vector<DemoStructure> aortaAndIliacArteries() {
  std::vector<Branch> iliacs;
  for (const float side : {-1.0f, 1.0f}) {
    const auto at = [side](float x, float y, float z) { return glm::vec3(4.0f + side * x, y, z); };
    iliacs.push_back({side < 0 ? "right iliac arteries" : "left iliac arteries",
                      {{{at(2.0f, -17, -84), 7.0f},
                        {at(4.6f, -16, -98), 6.6f},
                        {at(10.8f, -14, -113.5f), 6.2f},
                        {at(21, -11, -130), 6.0f},
                        {at(33, -8, -150), 5.8f},
                        {at(43, -7, -172), 5.2f},
                        {at(53, -14, -198), 5.0f},
                        {at(62, -30, -230), 4.8f},
                        {at(67, -40, -248), 4.8f}},
                       {{at(30, -8.5f, -145), 4.4f},
                        {at(34, -2, -156), 4.4f},
                        {at(38, 7, -171), 4.2f},
                        {at(38, 20, -190), 3.8f},
                        {at(35, 30, -212), 3.2f},
                        {at(34, 34, -240), 3.0f}}},
                      at(12.5f, -13.6f, -117)});
  }
  return vesselTree("abdominal aorta", arterial,
                    {{{{11, 8, 134}, 11.8f},
                      {{11, 5, 106}, 11.5f},
                      {{11, -1, 76}, 11.2f},
                      {{10, -7, 38}, 10.8f},
                      {{9, -12, 0}, 10.2f},
                      {{8, -15, -34}, 9.6f},
                      {{6, -17, -64}, 9.2f},
                      {{4.3f, -17, -92}, 8.8f}}},
                    iliacs);
}

DemoStructure coeliacTrunk() {
  return artery("coeliac trunk",
                {{{{10, -14, 20}, 3.6f}, {{9, -24, 21}, 3.6f}, {{8, -30, 22}, 3.4f}},
                 // left gastric
                 {{{8, -29, 22}, 2.0f},
                  {{10, -30, 40}, 1.9f},
                  {{14, -24, 62}, 1.8f},
                  {{23, -31, 62}, 1.6f},
                  {{25, -46, 44}, 1.4f}},
                 // splenic, winding along the pancreas
                 {{{8, -29, 22}, 2.8f},
                  {{20, -29, 25}, 2.7f},
                  {{32, -15, 20}, 2.7f},
                  {{44, -6, 30}, 2.6f},
                  {{56, 6, 24}, 2.6f},
                  {{68, 13, 34}, 2.5f},
                  {{82, 22, 36}, 2.3f},
                  {{92, 29, 44}, 2.0f}},
                 // common and proper hepatic
                 {{{8, -29, 22}, 2.6f},
                  {{-4, -32, 22}, 2.6f},
                  {{-16, -35, 19}, 2.5f},
                  {{-23, -33, 28}, 2.3f},
                  {{-25, -31, 42}, 2.0f},
                  {{-33, -30, 49}, 1.7f},
                  {{-46, -29, 54}, 1.4f}},
                 // left hepatic
                 {{{-24.5f, -31.5f, 40}, 1.7f}, {{-21, -34, 48}, 1.6f}, {{-12, -36, 55}, 1.4f}},
                 // gastroduodenal, down in front of the pancreas's head
                 {{{-15, -35, 19}, 2.0f},
                  {{-17, -41, 13}, 2.0f},
                  {{-20, -47, 4}, 1.9f},
                  {{-23, -49.5f, -8}, 1.8f},
                  {{-26, -48.5f, -20}, 1.6f},
                  {{-27, -46, -31}, 1.4f}}});
}

std::vector<DemoStructure> mesentericArteries() {
  return {artery("superior mesenteric artery",
                 {{{{9, -16, 4}, 3.8f},
                   {{8, -29, 1}, 3.9f},
                   {{5, -37, -12}, 3.8f},
                   {{3, -42, -32}, 3.6f},
                   {{2, -55, -54}, 3.4f},
                   {{-1, -56, -80}, 3.0f},
                   {{-8, -46, -104}, 2.4f},
                   {{-22, -38, -124}, 1.8f}},
                  {{{2, -55, -54}, 2.0f},
                   {{-6, -64.5f, -58}, 2.0f},
                   {{-17, -66, -64}, 2.0f},
                   {{-37, -60, -73}, 1.7f},
                   {{-60, -42, -80}, 1.4f}},
                  // right colic, before the vein
                  {{{0.5f, -56, -70}, 1.8f},
                   {{-11, -64.5f, -78}, 1.7f},
                   {{-26, -57, -88}, 1.5f},
                   {{-46, -42, -98}, 1.3f}},
                  // jejunal and ileal, in the mesentery
                  {{{2.5f, -50, -45}, 1.8f}, {{13, -54, -53}, 1.6f}, {{26, -51, -59}, 1.3f}},
                  {{{1.5f, -55.5f, -60}, 1.8f}, {{13, -58, -71}, 1.6f}, {{27, -55, -79}, 1.3f}},
                  {{{-1, -56, -80}, 1.7f}, {{9, -58, -92}, 1.5f}, {{22, -56, -102}, 1.3f}}}),
          artery("inferior mesenteric artery", {{{{8, -22, -62}, 2.4f},
                                                 {{11, -29, -74}, 2.4f},
                                                 {{22, -31, -98}, 2.2f},
                                                 {{30, -29, -130}, 2.0f},
                                                 {{28, -20, -160}, 1.7f}},
                                                {{{20, -31, -92}, 1.6f},
                                                 {{42, -28, -98}, 1.6f},
                                                 {{66, -18, -96}, 1.4f},
                                                 {{88, 0, -92}, 1.2f}}})};
}

std::vector<DemoStructure> renalArteries() {
  return {artery("right renal artery",
                 {{{{4, -8, -10}, 3.2f},
                   {{-8, 0, -12}, 3.2f},
                   {{-24, 6, -15}, 3.1f},
                   {{-38, 17, -15}, 3.0f},
                   {{-48, 25, -8}, 2.2f},
                   {{-58, 30, -1}, 1.5f}},
                  {{{-36, 15, -15}, 2.4f}, {{-46, 25, -20}, 2.1f}, {{-56, 30, -28}, 1.5f}}}),
          artery("left renal artery",
                 {{{{14, -9, -6}, 3.2f},
                   {{24, 0, -5}, 3.2f},
                   {{36, 13, -1}, 3.1f},
                   {{46, 22, 6}, 2.2f},
                   {{57, 27, 16}, 1.5f}},
                  {{{34, 11, -2}, 2.4f}, {{45, 22, -5}, 2.1f}, {{56, 28, -12}, 1.5f}}})};
}

/// Models the vena cava; the common iliac veins join behind the right common iliac artery.
std::vector<DemoStructure> cavaAndIliacVeins() {
  std::vector<Branch> iliacs;
  for (const float side : {-1.0f, 1.0f}) {
    const auto at = [side](float x, float y, float z) { return glm::vec3(side * x, y, z); };
    const bool right = side < 0;
    iliacs.push_back({right ? "right iliac veins" : "left iliac veins",
                      {{{right ? glm::vec3(-22, -11, -98) : glm::vec3(-18, -11, -98), 8.4f},
                        {right ? glm::vec3(-24, -8, -120) : glm::vec3(-13, -8, -117), 7.6f},
                        {right ? glm::vec3(-28, 2, -142) : glm::vec3(4, -3, -134), 7.0f},
                        {at(30, 8, -158), 6.8f},
                        {at(41, 10, -178), 6.2f},
                        {at(50, 2, -202), 5.8f},
                        {at(58, -17, -230), 5.4f},
                        {at(63, -27, -248), 5.2f}},
                       {{at(32, 8.5f, -161), 5.0f},
                        {at(36, 13, -172), 5.0f},
                        {at(38, 24, -188), 4.6f},
                        {at(35, 37, -212), 3.8f},
                        {at(34, 42, -240), 3.4f}}},
                      right ? glm::vec3(-25.5f, -4, -130) : glm::vec3(-4, -5, -126)});
  }
  return vesselTree("inferior vena cava", venous,
                    {{{{-14, -10, 134}, 12.5f},
                      {{-17, -8, 114}, 12.5f},
                      {{-20, -6, 92}, 12.5f},
                      {{-22, -6, 60}, 12.0f},
                      {{-22, -9, 24}, 11.5f},
                      {{-21, -12, -16}, 11.2f},
                      {{-21, -14, -60}, 10.8f},
                      {{-20, -12, -104}, 10.0f}}},
                    iliacs);
}

std::vector<DemoStructure> renalVeins() {
  return {vein("right renal vein",
               {{{{-26, -11, -18}, 5.0f},
                 {{-36, -2, -22}, 4.8f},
                 {{-46, 10, -19}, 4.0f},
                 {{-56, 18, -9}, 2.4f}},
                {{{-40, 2, -22}, 3.4f}, {{-48, 14, -26}, 3.0f}, {{-57, 20, -34}, 2.0f}}}),
          vein("left renal vein",
               {{{{-14, -18, -12}, 4.6f},
                 {{0, -25.5f, -11}, 4.4f},
                 {{14, -26, -8}, 4.4f},
                 {{26, -14, -4}, 4.8f},
                 {{38, 2, 0}, 4.6f},
                 {{48, 15, 6}, 3.4f},
                 {{58, 20, 16}, 2.2f}},
                {{{36, 0, -1}, 3.2f}, {{47, 14, -5}, 3.0f}, {{57, 20, -14}, 2.0f}}})};
}

/// Models the portal vein; the superior mesenteric and the splenic vein join behind the neck of the
/// pancreas.
std::vector<DemoStructure> portalVeins() {
  return vesselTree("portal vein", ofPortal,
                    {{{{-10, -36, 2}, 6.4f},
                      {{-17, -29, 14}, 6.2f},
                      {{-26, -21, 28}, 6.2f},
                      {{-32, -19, 42}, 5.6f},
                      {{-46, -19, 50}, 4.4f},
                      {{-58, -18, 54}, 3.2f}},
                     {{{-31, -19, 41}, 4.4f}, {{-22, -22, 48}, 4.0f}, {{-8, -27, 54}, 3.0f}}},
                    {{"superior mesenteric vein",
                      {{{{-11, -35, 5}, 6.0f},
                        {{-9.5f, -37, -2}, 5.8f},
                        {{-8, -40, -13}, 5.6f},
                        {{-8, -43, -32}, 5.4f},
                        {{-9, -56, -56}, 5.0f},
                        {{-13, -57, -82}, 4.2f},
                        {{-21, -46, -106}, 3.2f},
                        {{-34, -36, -126}, 2.4f}}},
                      {-9, -38, -5}},
                     {"splenic vein",
                      {{{{-11, -35, 4}, 4.8f},
                        {{-3, -35, 5}, 4.6f},
                        {{7, -33, 8}, 4.5f},
                        {{22, -22, 12}, 4.4f},
                        {{42, 0, 16}, 4.2f},
                        {{62, 14, 22}, 4.0f},
                        {{80, 24, 31}, 3.6f},
                        {{93, 31, 39}, 2.8f}}},
                      {1, -34.5f, 6}}});
}

std::vector<DemoStructure> joined(std::initializer_list<std::vector<DemoStructure>> parts) {
  std::vector<DemoStructure> all;
  for (const std::vector<DemoStructure>& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}
}  // namespace

std::vector<DemoStructure> abdomenArteries() {
  return joined({aortaAndIliacArteries(), {coeliacTrunk()}, mesentericArteries(), renalArteries()});
}

std::vector<DemoStructure> abdomenVeins() {
  return joined({cavaAndIliacVeins(), renalVeins(), portalVeins()});
}

}  // namespace sline::model
