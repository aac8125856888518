// SPDX-License-Identifier: Apache-2.0
// Models jejunum and ileum: one tube laid by hand from the duodenum's end to the caecum, then left
// to settle between colon, stomach and the back of the cavity.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <string_view>
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

/// The bowel leaves the duodenum straight, and comes straight to the medial wall of the caecum;
/// what lies between settles.
constexpr float straight = 16.0f;
constexpr glm::vec3 caecalMouth(-69, -45, -148);
constexpr glm::vec3 intoCaecum(-0.90f, 0.35f, 0.26f);

/// Returns the path on the left, where jejunum lies.
std::vector<glm::vec3> leftPath() {
  return {// from the duodenojejunal flexure, rows behind the transverse colon
          duodenojejunalFlexure + straight * intoJejunum,
          {66, -40, -55},
          {78, -32, -52},
          {90, -22, -46},
          {92, -20, -62},
          {80, -22, -74},
          {60, -28, -72},
          {46, -36, -78},
          {46, -44, -93},
          {66, -34, -90},
          {88, -27, -90},
          {94, -40, -108},
          {84, -66, -120},
          // in front, rows from side to side below it on the left
          {70, -88, -122},
          {36, -93, -127},
          {27, -93, -138},
          {38, -92, -147},
          {68, -89, -142},
          {86, -82, -149},
          {88, -82, -162},
          {72, -88, -166},
          {46, -92, -164},
          {30, -92, -170}};
}

/// Returns the path from there to the caecum.
std::vector<glm::vec3> rightPath() {
  return {// upright loops on the right
          {18, -88, -180},
          {7, -90, -172},
          {9, -92, -146},
          {4, -92, -126},
          {-9, -92, -124},
          {-15, -92, -142},
          {-11, -89, -168},
          {-17, -86, -182},
          {-30, -86, -180},
          {-33, -91, -158},
          {-32, -91, -136},
          {-44, -90, -126},
          {-55, -88, -138},
          {-54, -86, -164},
          {-58, -80, -184},
          // low across the brim of the pelvis
          {-50, -72, -200},
          {-34, -84, -208},
          {-8, -92, -212},
          {18, -94, -206},
          {40, -92, -196},
          {62, -88, -186},
          {82, -76, -184},
          {84, -66, -198},
          {62, -66, -207},
          {38, -62, -210},
          // and back behind, up to the caecum
          {36, -54, -190},
          {58, -50, -176},
          {66, -50, -156},
          {50, -46, -144},
          {32, -50, -154},
          {24, -54, -176},
          {6, -56, -184},
          {2, -54, -162},
          {6, -50, -142},
          {-12, -48, -134},
          {-20, -52, -152},
          {-20, -56, -174},
          {-38, -58, -180},
          {-46, -54, -162},
          caecalMouth - straight * intoCaecum};
}

std::vector<glm::vec3> laidPath() {
  std::vector<glm::vec3> path = leftPath();
  const std::vector<glm::vec3> onward = rightPath();
  path.insert(path.end(), onward.begin(), onward.end());
  return path;
}

DemoStructure stretch(const char* name, const std::shared_ptr<const Swept>& tube, float from,
                      float to) {
  const bool first = to < tube->length();
  const Field field = [=](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    if (at.distance > 8.0f)
      return at.distance;
    // Loops flatten where they touch.
    const float others = tube->distanceToOthers(p, at, 6.0f);
    const float wall = blendedDifference(at.distance, 0.5f * (others - at.distance) - 0.2f, 1.0f);
    return std::max(wall, std::max(tube->beyond(to, p, at), -tube->beyond(from, p, at)));
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

const Field& fieldNamed(const std::vector<DemoStructure>& there, std::string_view name) {
  return std::find_if(there.begin(), there.end(),
                      [name](const DemoStructure& s) { return s.name == name; })
      ->field;
}

/// Returns the place on the tube, from that end of it on, where it comes out of the organ.
float outOf(const Field& organ, const Swept& tube, float end) {
  constexpr float step = 0.25f;
  constexpr float clear = 1.2f;  // mm, a little more than what parts the two
  const float inward = end > 0.0f ? -step : step;
  float along = end;
  while (organ(tube.ring(along).position) < clear)
    along += inward;
  return along;
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
  std::vector<glm::vec3> line = settledCoil(laidPath(), {.radius = bowelRadius + 0.6f,
                                                         .spacing = 4.5f,
                                                         .keepOut = sampledKeepOut(keepOut),
                                                         .rounds = 40,
                                                         .stages = 12,
                                                         .settling = 6,
                                                         .growth = 1.12f});
  line.insert(line.begin(), {duodenojejunalFlexure - 4.0f * intoJejunum, duodenojejunalFlexure,
                             duodenojejunalFlexure + 0.5f * straight * intoJejunum});
  line.insert(line.end(), {caecalMouth - 0.5f * straight * intoCaecum, caecalMouth});
  // The tube narrows towards its end, with slow waves of narrower and wider places.
  std::vector<SweptPoint> points;
  for (std::size_t i = line.size() % 2 == 0 ? 1 : 0; i < line.size(); i += 2) {
    const float share = float(i) / float(line.size());
    const float wave = 0.35f * std::sin(0.31f * float(i)) + 0.25f * std::sin(0.19f * float(i) + 1);
    points.push_back({line[i], bowelRadius * (1.06f - 0.12f * share) + wave});
  }
  const auto tube = std::make_shared<Swept>(points, glm::vec3(0, -1, 0), 2.5f);
  const float middle = 0.36f * tube->length();
  return {
      stretch("jejunum", tube, outOf(fieldNamed(there, "duodenum"), *tube, 0.0f), middle - 0.3f),
      stretch("ileum", tube, middle + 0.3f,
              outOf(fieldNamed(there, "ascending colon"), *tube, tube->length()))};
}

}  // namespace sline::model
