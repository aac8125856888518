// SPDX-License-Identifier: Apache-2.0
// Models jejunum and ileum: one tube laid by hand from the duodenum's end to the caecum, then left
// to settle between colon, stomach and the back of the cavity.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "model/demo/abdomen/parts.h"
#include "model/sculpting/coil.h"
#include "model/sculpting/sampled_field.h"
#include "model/sculpting/swept.h"
#include "model/sculpting/tube_mesh.h"

namespace sline::model {

namespace {
constexpr float bowelRadius = 9.4f;

/// Returns the distance within the peritoneal cavity to its back, which bulges in the middle around
/// the mesentery's vessels, to its front, to its narrowing low down and to its sides.
float cavityWall(const glm::vec3& p) {
  const float aside = std::clamp((std::abs(p.x) - 26.0f) / 40.0f, 0.0f, 1.0f);
  const float back = -31.0f + 32.0f * aside * aside * (3.0f - 2.0f * aside);
  const float front = -112.0f + 0.0022f * p.x * p.x;
  const float floor = -222.0f + 0.002f * p.x * p.x;
  return std::min({back - p.y, p.y - front, p.z - floor, 100.0f - std::abs(p.x)});
}

std::vector<glm::vec3> laidPath() {
  return {// from the duodenojejunal flexure, rows behind the transverse colon
          {46.4f, -44.4f, -28.3f},
          {54, -50, -36},
          {76, -30, -34},
          {90, -22, -46},
          {84, -22, -66},
          {62, -26, -64},
          {44, -36, -72},
          {46, -40, -92},
          {66, -28, -90},
          {88, -20, -92},
          {94, -40, -108},
          {84, -66, -120},
          // a front layer of upright loops below it
          {82, -84, -146},
          {74, -84, -172},
          {58, -86, -170},
          {52, -88, -142},
          {42, -90, -122},
          {28, -90, -130},
          {24, -90, -160},
          {16, -88, -182},
          {0, -90, -176},
          {-4, -92, -146},
          {-14, -92, -124},
          {-30, -90, -132},
          {-34, -88, -160},
          {-44, -80, -180},
          // low across the brim of the pelvis
          {-36, -66, -202},
          {-10, -72, -208},
          {18, -72, -210},
          {44, -74, -206},
          {62, -68, -196},
          // and back behind, up to the caecum
          {64, -52, -166},
          {56, -46, -140},
          {32, -48, -136},
          {26, -56, -158},
          {4, -56, -160},
          {-4, -50, -138},
          {-24, -50, -132},
          {-34, -52, -150},
          {-48, -52, -158},
          {-66, -46, -148}};
}

DemoStructure stretch(const char* name, const std::shared_ptr<const Swept>& tube, float from,
                      float to) {
  const bool first = from <= 0.0f;
  const Field field = [=](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    if (at.distance > 8.0f)
      return at.distance;
    // Loops flatten where they touch.
    const float others = tube->distanceToOthers(p, at, 6.0f);
    const float wall = blendedDifference(at.distance, 0.5f * (others - at.distance) - 0.2f, 1.0f);
    return std::max(wall, first ? tube->beyond(to, p, at) : -tube->beyond(from, p, at));
  };
  DemoStructure s{.name = name,
                  .groups = {"Digestive system"},
                  .colour = bowelColour,
                  .gamma = Gamma::clamped(1.4f),
                  .inkColour = bowelInk,
                  .field = field,
                  .box = grown(tube->bounds(from, to), 4.0f)};
  s.edge = 2.8f;
  s.gap = 1.0f;
  s.mesher = [=](const Field& solid, float edge) {
    return tubeMesh(*tube, {.from = from, .to = to, .edge = edge, .rim = 1.5f}, solid);
  };
  s.rounding = 2.0f;
  s.wall = 1.8f;
  // The circular folds are closer together in the jejunum.
  s.folds = [=](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    return first ? 0.9f + 0.9f * std::sin(at.along * 2.0f * std::numbers::pi_v<float> / 7.5f +
                                          std::sin(at.angle))
                 : 0.4f + 0.4f * std::sin(at.along * 2.0f * std::numbers::pi_v<float> / 11.0f);
  };
  return s;
}

/// Returns the region closed to the bowel as samples, which are quick to read, since it is read
/// many times for each point of the tube.
Field sampledKeepOut(const Field& keepOut) {
  const Box cavity{{-110, -124, -234}, {112, -4, 0}};
  const auto samples = std::make_shared<const SampledField>(
      [&](const glm::vec3&, float) { return keepOut; }, cavity, SampledField::Fineness{5.0f, 4.0f});
  return [samples](const glm::vec3& p) { return samples->distance(p); };
}
}  // namespace

std::vector<DemoStructure> abdomenBowel(const std::vector<DemoStructure>& there) {
  const Field keepOut = [&there](const glm::vec3& p) {
    float d = cavityWall(p);
    for (const DemoStructure& organ : there)
      if (const float toBox = distanceToBox(organ.box, p); toBox < d && toBox < bowelRadius)
        d = std::min(d, organ.field(p));
    return d;
  };
  const std::vector<glm::vec3> line = settledCoil(laidPath(), {.radius = bowelRadius + 0.6f,
                                                               .spacing = 4.5f,
                                                               .keepOut = sampledKeepOut(keepOut),
                                                               .rounds = 40,
                                                               .stages = 15,
                                                               .settling = 6,
                                                               .growth = 1.13f});
  // The tube narrows towards its end, with slow waves of narrower and wider places.
  std::vector<SweptPoint> points;
  for (std::size_t i = 0; i < line.size(); i += 2) {
    const float share = float(i) / float(line.size());
    const float wave = 0.35f * std::sin(0.31f * float(i)) + 0.25f * std::sin(0.19f * float(i) + 1);
    points.push_back({line[i], bowelRadius * (1.06f - 0.12f * share) + wave});
  }
  const auto tube = std::make_shared<Swept>(points, glm::vec3(0, -1, 0), 2.5f);
  const float middle = 0.36f * tube->length();
  return {stretch("jejunum", tube, 0.0f, middle - 0.3f),
          stretch("ileum", tube, middle + 0.3f, tube->length())};
}

}  // namespace sline::model
