// SPDX-License-Identifier: Apache-2.0
// Models the alimentary canal: swept walls, folded where the organ is.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "model/demo/abdomen/parts.h"
#include "model/sculpting/swept.h"

namespace sline::model {

namespace {
constexpr Colour stomachColour{217, 143, 134};
constexpr Colour colonColour{191, 138, 99};

DemoStructure organ(std::string name, Colour colour, float gamma, Field field, Box box) {
  return {.name = std::move(name),
          .groups = {"Digestive system"},
          .colour = colour,
          .gamma = Gamma::clamped(gamma),
          .field = std::move(field),
          .box = box};
}

/// Returns how much thicker the rugae, folds along the cavity, make the wall, mm. They fade towards
/// the pylorus.
float rugae(const SweptCoordinates& at, float length) {
  const float phase = 7.0f * at.angle + 1.1f * std::sin(at.along / 17.0f) +
                      0.7f * std::sin(at.along / 9.0f + 2.0f * at.angle);
  const float fade = std::clamp((length - at.along) / 60.0f, 0.0f, 1.0f);
  return (0.3f + 0.9f * fade) * (1.0f + std::sin(phase));
}

/// The middle of the pylorus, where the stomach ends and the duodenum begins.
constexpr glm::vec3 pylorus(-32, -56, 0);

/// Returns by how much the wall of the stomach's end lies further in (positive) or out: the pyloric
/// antrum, a shallow furrow where the pyloric canal begins, the ring of muscle at its end.
float pyloricRelief(float beforePylorus) {
  const auto ring = [=](float place, float width) {
    const float d = (beforePylorus - place) / width;
    return std::exp(-0.5f * d * d);
  };
  return 1.7f * ring(27.0f, 5.0f) + 1.3f * ring(13.0f, 5.0f) - 1.6f * ring(4.5f, 3.0f) +
         1.6f * ring(-1.0f, 2.5f);
}

DemoStructure stomach() {
  // From the fundus along the middle to the pylorus: the body sinks to the left and forward, the
  // antrum climbs to the right.
  const auto body =
      std::make_shared<Swept>(std::array<SweptPoint, 11>{{{{62, 8, 90}, 29, 1.0f},
                                                          {{67, -6, 67}, 35, 0.93f},
                                                          {{70, -27, 40}, 37, 0.85f},
                                                          {{68, -46, 14}, 36.5f, 0.80f},
                                                          {{58, -61, -10}, 34, 0.80f},
                                                          {{39, -71, -27}, 29, 0.84f},
                                                          {{18, -75, -31}, 25.5f, 0.90f},
                                                          {{0, -73, -26}, 23.5f, 0.95f},
                                                          {{-14, -68, -16}, 18.5f, 1.0f},
                                                          {{-24, -62, -7}, 12.5f, 1.0f},
                                                          {pylorus, 10.5f, 1.0f}}},
                              glm::vec3(0, -1, 0));
  // The gullet comes to the cardia from the right; the cardial notch parts it from the fundus.
  const auto gullet = std::make_shared<Swept>(std::array<SweptPoint, 6>{{{{16, -20, 132}, 8.5f},
                                                                         {{15, -21, 106}, 8.5f},
                                                                         {{16, -21, 88}, 8.5f},
                                                                         {{21, -20, 72}, 9.5f},
                                                                         {{32, -19, 59}, 14.0f},
                                                                         {{47, -18, 50}, 17.0f}}},
                                              glm::vec3(0, -1, 0));
  const Field field = [body, gullet](const glm::vec3& p) {
    const SweptCoordinates at = body->place(p);
    const float d = blendedUnion(at.distance + pyloricRelief(body->length() - at.along),
                                 gullet->distance(p), 6.0f);
    // The angular notch of the lesser curvature parts body and antrum.
    const float notch = Blob({23, -70, 4}, {5.5f, 36.0f, 23.0f}, {0, 26, 0}).distance(p);
    const float notched = blendedDifference(d, notch, 8.0f);
    return -blendedUnion(-notched, -body->beyond(body->length(), p, at), 1.5f);
  };
  Box box = grown(body->bounds(), 5.0f);
  box.add(gullet->bounds());
  DemoStructure s = organ("stomach", stomachColour, 4.3f, field, grown(box, 3.0f));
  s.edge = 2.3f;
  s.rounding = 6.0f;
  s.gap = 1.2f;
  s.smoothing = 3.0f;
  s.wall = 2.6f;
  s.folds = [body](const glm::vec3& p) { return rugae(body->place(p), body->length()); };
  return s;
}

DemoStructure duodenum() {
  const auto tube =
      std::make_shared<Swept>(std::array<SweptPoint, 17>{{{pylorus, 10},
                                                          {{-37, -52, 4}, 13.5f},
                                                          {{-45, -44, 8}, 15.5f},
                                                          {{-55, -30, 7}, 13.5f},
                                                          {{-60, -17, -2}, 13.5f},
                                                          {{-61, -10, -20}, 13.5f},
                                                          {{-59, -9, -40}, 13.5f},
                                                          {{-53, -16, -58}, 14},
                                                          {{-40, -26, -69}, 13.5f},
                                                          {{-20, -36, -72}, 13},
                                                          {{0, -40, -71}, 12.5f},
                                                          {{19, -36, -64}, 12.5f},
                                                          {{29, -29, -48}, 12.5f},
                                                          {{31, -27, -33}, 12.5f},
                                                          {{37, -30, -22}, 12.0f},
                                                          {{45, -34, -22}, 11.0f},
                                                          {duodenojejunalFlexure, 10.0f}}},
                              glm::vec3(0, -1, 0));
  DemoStructure s = organ(
      "duodenum", bowelColour, 3.0f,
      [tube](const glm::vec3& p) {
        // The stomach comes before the duodenum, the jejunum after it.
        const SweptCoordinates at = tube->place(p);
        const float d = -blendedUnion(-at.distance, tube->beyond(0.0f, p, at), 1.5f);
        return -blendedUnion(-d, -tube->beyond(tube->length(), p, at), 1.5f);
      },
      grown(tube->bounds(), 4.0f));
  s.inkColour = bowelInk;
  s.edge = 2.0f;
  s.rounding = 3.0f;
  s.gap = 0.8f;
  s.smoothing = 1.6f;
  s.wall = 1.8f;
  // The superior part is smooth; further on circular folds stand into the cavity.
  s.folds = [tube](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    const float further = std::clamp((at.along - 30.0f) / 30.0f, 0.0f, 1.0f);
    return further * (1.0f + std::sin(at.along * 2.0f * std::numbers::pi_v<float> / 8.0f +
                                      0.8f * std::sin(at.angle + 1.0f)));
  };
  return s;
}

/// Returns the distance to the colon's wall, which three bands of muscle, the taeniae, gather into
/// sacs.
float haustrated(const SweptCoordinates& at) {
  if (at.distance > 10.0f)
    return at.distance - 2.0f;
  const float across = std::sin(1.5f * at.angle);
  const float band = across * across;
  const float sac = std::sqrt(std::sqrt(band + 0.004f));
  // The folds vary a little in length and are staggered between the bands.
  const float phase =
      2.75f * at.widths + 0.5f * std::sin(0.83f * at.widths) + 0.9f * std::sin(at.angle + 0.6f);
  const float wave = std::sin(phase);
  const float swell = std::sqrt(std::sqrt(wave * wave + 0.004f));
  const float end = std::clamp(1.3f * at.widths, 0.0f, 1.0f);
  const float hollow = 0.36f * (1.0f - swell) * sac + 0.12f * (1.0f - sac);
  const float taenia = 0.05f * std::exp(-band / 0.02f);
  return at.distance + at.radius * (hollow * (0.3f + 0.7f * end) - taenia * end);
}

/// Returns the whole colon, from which its parts are cut.
std::shared_ptr<const Swept> colonTube() {
  return std::make_shared<Swept>(
      std::array<SweptPoint, 32>{
          {{{-82, -44, -160}, 25},   {{-92, -34, -142}, 31},   {{-101, -20, -114}, 28},
           {{-106, -4, -86}, 26},    {{-106, 4, -60}, 26},     {{-99, -6, -40}, 25},
           {{-89, -28, -40}, 24},    {{-82, -52, -52}, 23.5f}, {{-68, -70, -68}, 24},
           {{-44, -80, -80}, 24},    {{-14, -86, -88}, 23},    {{18, -87, -88}, 22},
           {{50, -82, -76}, 22},     {{78, -68, -54}, 21},     {{97, -46, -24}, 21},
           {{109, -22, 2}, 20},      {{115, 2, 20}, 19},       {{119, 24, 20}, 18},
           {{121, 36, 2}, 17.5f},    {{120, 38, -24}, 18},     {{117, 32, -54}, 17.5f},
           {{113, 22, -86}, 17},     {{107, 8, -116}, 16.5f},  {{98, -8, -144}, 16},
           {{86, -22, -168}, 15.5f}, {{66, -30, -187}, 16.5f}, {{42, -36, -192}, 17},
           {{18, -34, -184}, 17},    {{-8, -22, -182}, 17},    {{-22, -2, -192}, 17},
           {{-16, 18, -210}, 16.5f}, {{-2, 36, -240}, 16}}},
      glm::vec3(0, -1, 0));
}

/// Holds where a stretch of a tube begins and ends; absent where the tube itself begins or ends.
struct Stretch {
  std::optional<float> from;
  std::optional<float> to;
};

/// Closes the wall where the stretch begins and ends, with slightly rounded rims.
float within(const Swept& tube, const Stretch& stretch, const glm::vec3& p,
             const SweptCoordinates& at, float wall) {
  float d = wall;
  if (stretch.from)
    d = -blendedUnion(-d, tube.beyond(*stretch.from, p, at), 3.0f);
  if (stretch.to)
    d = -blendedUnion(-d, -tube.beyond(*stretch.to, p, at), 3.0f);
  return d;
}

DemoStructure colonPart(const char* name, const std::shared_ptr<const Swept>& tube,
                        const Stretch& stretch) {
  const Field field = [tube, stretch](const glm::vec3& p) {
    const SweptCoordinates at = tube->place(p);
    return within(*tube, stretch, p, at, haustrated(at));
  };
  const Box box = tube->bounds(stretch.from.value_or(0.0f), stretch.to.value_or(tube->length()));
  DemoStructure s = organ(name, colonColour, 1.4f, field, grown(box, 4.0f));
  s.inkColour = bowelInk;
  s.edge = 2.5f;
  s.rounding = 2.0f;
  s.smoothing = 1.4f;
  s.wall = 2.2f;
  return s;
}

DemoStructure appendix() {
  const auto tube = std::make_shared<Swept>(std::array<SweptPoint, 6>{{{{-85, -42, -168}, 4.2f},
                                                                       {{-79, -44, -186}, 4.0f},
                                                                       {{-70, -42, -200}, 3.8f},
                                                                       {{-57, -42, -207}, 3.6f},
                                                                       {{-46, -46, -206}, 3.5f},
                                                                       {{-40, -50, -198}, 3.3f}}},
                                            glm::vec3(0, -1, 0));
  DemoStructure s = organ(
      "vermiform appendix", colonColour, 1.4f,
      [tube](const glm::vec3& p) { return tube->distance(p); }, grown(tube->bounds(), 3.0f));
  s.inkColour = bowelInk;
  s.edge = 1.3f;
  return s;
}

std::vector<DemoStructure> colons() {
  const auto tube = colonTube();
  constexpr float gap = 0.3f;
  const float hepatic = tube->alongNearest({-92, -20, -38});
  const float splenic = tube->alongNearest({119, 26, 18});
  const float brim = tube->alongNearest({90, -18, -162});
  return {colonPart("ascending colon", tube, {.to = hepatic - gap}),
          colonPart("transverse colon", tube, {hepatic + gap, splenic - gap}),
          colonPart("descending colon", tube, {splenic + gap, brim - gap}),
          colonPart("sigmoid colon", tube, {.from = brim + gap}), appendix()};
}
}  // namespace

std::vector<DemoStructure> abdomenGut() {
  std::vector<DemoStructure> gut{duodenum(), stomach()};
  for (DemoStructure& s : colons())
    gut.push_back(std::move(s));
  return gut;
}

}  // namespace sline::model
