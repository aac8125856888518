// SPDX-License-Identifier: Apache-2.0
// What differs: the genital organs and the urethra of a man and of a woman.
#include <cmath>
#include <utility>

#include "model/demo/pelvis_bones.h"
#include "model/demo/pelvis_parts.h"

namespace sline::model {

namespace {
constexpr float x0 = pelvisMiddle - 0.4f;
constexpr Colour urinaryColour{226, 178, 96};
constexpr Colour prostateColour{196, 138, 118};
constexpr Colour seminalColour{206, 150, 168};
constexpr Colour uterusColour{201, 128, 138};
constexpr Colour ovaryColour{232, 208, 190};

Palette genital(Colour colour, float edge) {
  Palette palette = organPalette;
  palette.colour = colour;
  palette.edge = edge;
  return palette;
}

/// A chestnut: base up under the bladder, apex down, a furrow behind between the two lobes.
Shape prostate() {
  const std::vector<Blob> parts{Blob({x0 - 6, -88.5f, 849.5f}, {12.5f, 15, 9.6f}, {-15, 0, 0}),
                                Blob({x0 + 6, -88.5f, 849.5f}, {12.5f, 15, 9.6f}, {-15, 0, 0}),
                                Blob({x0, -95, 848}, {11, 11.5f, 9}),
                                Blob({x0, -92, 843}, {8.5f, 8, 6})};
  return rippled(
      {[parts](const glm::vec3& p) { return blended(std::span<const Blob>(parts), p, 5.0f); },
       boundsOf(std::span<const Blob>(parts))},
      22.0f, 0.35f, 0.3f);
}

/// One tube, coiled upon itself: bulges left and right of a slanting line.
Shape seminalVesicle() {
  std::vector<TubePoint> coil{{{4.4f, -80.8f, 858.5f}, 2.3f}};
  for (int i = 1; i < 12; ++i) {
    const float t = float(i) / 12.0f;
    const float turn = (i % 2 == 0 ? 1.0f : -1.0f) * 2.9f * std::sin(3.0f * t + 0.2f);
    coil.push_back({{5.0f + 26.0f * t + 0.75f * turn, -78.5f + 11.0f * t - 0.8f * std::abs(turn),
                     859.5f + 23.0f * t - 0.75f * turn},
                    2.4f + 2.0f * std::sin(3.0f * t)});
  }
  coil.push_back({{32, -66.5f, 883}, 3.2f});
  return shapeOf(Tube(coil));
}

/// Out of the scrotum (cut at its upper pole), through the inguinal canal, over the ureter and
/// medially behind the bladder, where it widens.
Shape deferentDuct() {
  return shapeOf(
      Tube{{{18.5f, -155, 756}, 2.1f}, {{19, -152.5f, 774}, 2},  {{20, -154, 789}, 2},
           {{20, -156, 803}, 2},       {{20, -158, 817}, 2},     {{21, -160, 831}, 2},
           {{23, -163, 845}, 2},       {{26.5f, -166, 859}, 2},  {{33, -167.5f, 873}, 2},
           {{45, -168, 887}, 2},       {{63, -164.5f, 900}, 2},  {{82, -158, 915}, 2},
           {{92.5f, -148, 926}, 2},    {{92, -137, 930.5f}, 2},  {{83, -124, 930.5f}, 2},
           {{70, -112, 928}, 2},       {{57, -101, 927}, 2},     {{45, -90, 924}, 2},
           {{36, -78, 914.5f}, 2},     {{28, -65.5f, 901}, 2},   {{20.5f, -62.5f, 893}, 2.4f},
           {{12.5f, -63, 884}, 2.9f},  {{7, -66.5f, 873}, 2.9f}, {{4.8f, -72.5f, 862}, 2}});
}

/// Through the prostate and the pelvic floor, forward under the symphysis, then down.
Shape maleUrethra() {
  return shapeOf(Tube{{{x0, -90, 860}, 1.08f},
                      {{x0, -94, 848}, 1.08f},
                      {{x0, -100, 840}, 1.08f},
                      {{x0, -112, 835.5f}, 1.08f},
                      {{x0, -127, 835}, 1.08f},
                      {{x0, -147, 837}, 1.08f},
                      {{x0, -167, 838}, 1.08f},
                      {{x0, -180, 831}, 1.08f},
                      {{x0, -190.5f, 815}, 1.08f},
                      {{x0, -197.5f, 796}, 1.08f},
                      {{x0, -201, 770}, 1.08f}});
}
}  // namespace

std::vector<DemoStructure> maleOrgans() {
  std::vector<DemoStructure> list;
  list.push_back(structure(genital(urinaryColour, 0.7f), "urethra", maleUrethra()));
  list.push_back(structure(genital(prostateColour, 1.2f), "prostate", prostate()));
  addPair(list, genital(seminalColour, 1.0f), "seminal vesicle", seminalVesicle());
  addPair(list, genital(seminalColour, 1.1f), "deferent duct", deferentDuct());
  return list;
}

namespace {
/// Bent forward over the bladder: neck, isthmus, body, and the fundus between the tubes.
Shape uterus() {
  Shape body = shapeOf(Band{{{x0, -73, 866}, 11, 10, {1, 0, 0}},
                            {{x0, -74, 876}, 11.5f, 10.5f, {1, 0, 0}},
                            {{x0, -79, 888}, 11, 9.5f, {1, 0, 0}},
                            {{x0, -89, 899}, 17, 12.5f, {1, 0, 0}},
                            {{x0, -102, 907}, 24, 15.5f, {1, 0, 0}},
                            {{x0, -110, 910.5f}, 25, 15, {1, 0, 0}}});
  Shape horns = branching({Tube{{{x0 - 12, -106, 909}, 8}, {{x0 - 25, -108.5f, 912}, 3.6f}},
                           Tube{{{x0 + 12, -106, 909}, 8}, {{x0 + 25, -108.5f, 912}, 3.6f}}},
                          6.0f);
  return rippled(merged(std::move(body), std::move(horns), 8.0f), 40.0f, 0.4f, 1.3f);
}

/// Flat from front to back, around the neck of the uterus above.
Shape vagina() {
  return shapeOf(Band{{{x0, -90, 820}, 8, 3.6f, {1, 0, 0}},
                      {{x0, -86, 828}, 10, 3.8f, {1, 0, 0}},
                      {{x0, -80, 840}, 12.5f, 4.2f, {1, 0, 0}},
                      {{x0, -74.5f, 852}, 14, 5.2f, {1, 0, 0}},
                      {{x0, -72, 862}, 15, 7.5f, {1, 0, 0}},
                      {{x0, -72, 868}, 14.5f, 10, {1, 0, 0}}});
}

/// An almond with scars of past follicles, hung by its ligament from the horn of the uterus.
Shape ovary() {
  Shape body =
      rippled(shapeOf(Blob({35.5f, -93, 911}, {7.5f, 10, 14}, {24, 12, -8})), 9.0f, 0.75f, 1.9f);
  Shape ligament = shapeOf(Tube{{{23, -104, 906.5f}, 1.6f},
                                {{27, -102, 903.5f}, 1.5f},
                                {{32, -97, 904}, 1.7f},
                                {{35, -94, 908}, 2}});
  return merged(std::move(body), std::move(ligament), 3.0f);
}

/// From the horn outward and back over the ovary; the funnel's fringes hang around its mouth.
Shape uterineTube() {
  std::vector<Tube> parts{Tube{{{23, -109, 913}, 1.9f},
                               {{31, -112, 917}, 1.6f},
                               {{39, -110, 922}, 1.9f},
                               {{45, -103, 926}, 2.3f},
                               {{46, -94, 927}, 2.8f},
                               {{43, -86, 924}, 3.6f},
                               {{39.5f, -81.5f, 919}, 4.4f}}};
  constexpr int fringes = 7;
  for (int i = 0; i < fringes; ++i) {
    const float angle = 6.2831853f * float(i) / float(fringes);
    const glm::vec3 out = 3.6f * std::cos(angle) * glm::vec3(0.85f, -0.5f, 0.1f) +
                          3.6f * std::sin(angle) * glm::vec3(0.2f, 0.45f, 0.87f);
    const glm::vec3 mouth(39, -81, 918);
    parts.push_back(
        Tube{{mouth + 0.6f * out, 2},
             {mouth + 1.2f * out + glm::vec3(-1.8f, 2.2f, -3), 1.5f},
             {mouth + (i % 2 == 0 ? 1.5f : 1.8f) * out + glm::vec3(-3.6f, 3.4f, -6), 1}});
  }
  return branching(std::move(parts), 2.0f);
}
}  // namespace

std::vector<DemoStructure> femaleOrgans() {
  std::vector<DemoStructure> list;
  list.push_back(structure(genital(urinaryColour, 1.1f), "urethra",
                           shapeOf(Tube{{{x0, -101, 856}, 3.2f},
                                        {{x0, -101.5f, 846}, 3},
                                        {{x0, -103.5f, 834}, 3},
                                        {{x0, -107, 823}, 3.2f}})));
  list.push_back(structure(genital(uterusColour, 1.6f), "uterus", uterus()));
  list.push_back(structure(genital(uterusColour, 1.4f), "vagina", vagina()));
  addPair(list, genital(ovaryColour, 1.1f), "ovary", ovary());
  addPair(list, genital(uterusColour, 0.9f), "uterine tube", uterineTube());
  return list;
}

}  // namespace sline::model
