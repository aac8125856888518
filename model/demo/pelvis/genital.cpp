// SPDX-License-Identifier: Apache-2.0
// Models the organs that differ: the genital organs and the urethra of a man and of a woman.
#include <array>
#include <cmath>
#include <utility>

#include "model/demo/pelvis/bones.h"
#include "model/demo/pelvis/parts.h"

namespace sline::model {

namespace {
constexpr float x0 = pelvisMiddle - 0.4f;
constexpr Colour prostateColour{196, 138, 118};
constexpr Colour seminalColour{206, 150, 168};
constexpr Colour penisColour{206, 148, 140};
constexpr Colour testisColour{228, 212, 196};
constexpr Colour genitalInk{112, 66, 62};
constexpr Colour uterusColour{201, 128, 138};
constexpr Colour vaginaColour{214, 152, 152};
constexpr Colour ovaryColour{232, 208, 190};

Palette genital(Colour colour, float edge) {
  Palette palette = organPalette;
  palette.colour = colour;
  palette.edge = edge;
  return palette;
}

/// The prostate is a chestnut: base up under the bladder, apex down, a furrow behind between the
/// two lobes.
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

/// The seminal vesicle is one coiled tube: bulges left and right of a slanting line.
Shape seminalVesicle() {
  std::vector<TubePoint> coil{{{4.4f, -80.8f, 858.5f}, 2.3f}};
  for (int i = 1; i < 12; ++i) {
    const float t = float(i) / 12.0f;
    const float turn = (i % 2 == 0 ? 1.0f : -1.0f) * 2.9f * std::sin(3.0f * t + 0.2f);
    coil.push_back({{5.0f + 26.0f * t + 0.75f * turn, -78.5f + 11.0f * t - 0.8f * std::abs(turn),
                     859.5f + 23.0f * t - 0.75f * turn},
                    2.4f + 2.0f * std::sin(3.0f * t)});
  }
  coil.push_back({{32, -65, 883.5f}, 3.6f});
  return shapeOf(Tube(coil));
}

/// The duct runs from the tail of the epididymis up through the inguinal canal, over the ureter and
/// medially behind the bladder, where it widens.
Shape deferentDuct() {
  return shapeOf(
      Tube{{{20, -151, 734.5f}, 1.9f},   {{17.8f, -147.5f, 741}, 2}, {{17, -146.5f, 752}, 2},
           {{18.3f, -149.5f, 771}, 2},   {{20, -154, 789}, 2},       {{20, -156, 803}, 2},
           {{20, -158, 817}, 2},         {{21, -160, 831}, 2},       {{23, -163, 845}, 2},
           {{26.5f, -166, 859}, 2},      {{33, -167.5f, 873}, 2},    {{45, -168, 887}, 2},
           {{63, -164.5f, 900}, 2},      {{82, -158, 915}, 2},       {{92.5f, -148, 926}, 2},
           {{92, -137, 930.5f}, 2},      {{83, -124, 930.5f}, 2},    {{70, -112, 928}, 2},
           {{57, -101.5f, 928}, 2},      {{47, -94, 928}, 2},        {{38, -84, 923}, 2},
           {{31.5f, -73.5f, 912.5f}, 2}, {{26, -65, 901}, 2},        {{20.5f, -62.5f, 893}, 2.4f},
           {{12.5f, -63, 884}, 2.9f},    {{7, -66.5f, 873}, 2.9f},   {{4.8f, -72.5f, 862}, 2}});
}

/// The urethra runs through the prostate and the pelvic floor, forward under the symphysis, then
/// down.
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
/// The spongy body surrounds the urethra: bulb, shaft and glans.
Shape corpusSpongiosum() {
  Shape shaft = shapeOf(Tube{{{x0, -89, 829}, 6},
                             {{x0, -100, 829.5f}, 8.8f},
                             {{x0, -112, 831.5f}, 8.6f},
                             {{x0, -128, 834}, 6.8f},
                             {{x0, -147, 836.5f}, 6.2f},
                             {{x0, -166, 837}, 6},
                             {{x0, -180, 830.5f}, 6},
                             {{x0, -190.5f, 815}, 6},
                             {{x0, -197.5f, 796}, 6.2f},
                             {{x0, -200, 785}, 6.5f}});
  const std::vector<Blob> glans{Blob({x0, -201, 781.5f}, {12.5f, 12, 12}),
                                Blob({x0, -201.2f, 787}, {13.5f, 13.5f, 6.5f}, {14, 0, 0})};
  Shape tip{[glans](const glm::vec3& p) { return blended(std::span<const Blob>(glans), p, 6.0f); },
            boundsOf(std::span<const Blob>(glans))};
  return merged(std::move(shaft), std::move(tip), 4.0f);
}

/// The cavernous bodies run from the rami of the pubis, joined under the symphysis, along the back
/// of the penis.
Shape corporaCavernosa() {
  const auto half = [](float side) {
    const auto at = [side](float x, float y, float z) { return glm::vec3(x0 + side * x, y, z); };
    return Tube{{at(27, -92, 822), 3.5f},     {at(21.5f, -104, 831), 5.2f},
                {at(14, -118, 838.5f), 6.4f}, {at(7.5f, -135, 844), 6.8f},
                {at(5.2f, -153, 848.5f), 7},  {at(5, -170, 848.5f), 7},
                {at(5, -186, 841), 7},        {at(5, -198.5f, 824), 7},
                {at(5, -206, 803), 6.8f},     {at(4.6f, -207.5f, 792), 5.6f}};
  };
  return branching({half(-1), half(1)}, 4.0f);
}

/// The testis is an egg whose back, where the epididymis lies, is flat.
Shape testis() {
  Shape egg = cutOff(shapeOf(Blob({23, -162.5f, 748}, {12.8f, 16.5f, 22.5f}, {-10, 0, 0})),
                     {23, -151.5f, 748}, {0, 1, 0.17f}, 8.0f);
  return rippled(std::move(egg), 26.0f, 0.5f, 0.7f);
}

/// The epididymis is a comma along the back of the testis: the head caps its upper pole, the body
/// is thin, and at the tail below the duct begins.
Shape epididymis() {
  return shapeOf(Tube{{{22.8f, -163, 771}, 4},
                      {{23, -157.5f, 770}, 5.6f},
                      {{23.4f, -152, 766}, 5.4f},
                      {{24, -148.5f, 759}, 3.9f},
                      {{24.6f, -147.8f, 750}, 3.2f},
                      {{24.2f, -148, 740}, 3.2f},
                      {{23, -150, 731.5f}, 3.9f},
                      {{21.5f, -153.5f, 726.5f}, 3.6f},
                      {{19.8f, -152, 731}, 2.4f}});
}
}  // namespace

std::vector<DemoStructure> maleOrgans() {
  std::vector<DemoStructure> list;
  list.push_back(structure(genital(urinaryColour, 0.7f), "urethra", maleUrethra()));
  list.push_back(structure(genital(prostateColour, 1.2f), "prostate", prostate()));
  addPair(list, genital(seminalColour, 1.0f), "seminal vesicle", seminalVesicle());
  addPair(list, genital(seminalColour, 1.2f), "deferent duct", deferentDuct());
  // The following structures lie outside the pelvis, and so are context.
  const std::size_t outer = list.size();
  list.push_back(
      structure(genital(penisColour, 1.8f), "corpus spongiosum of penis", corpusSpongiosum()));
  list.push_back(
      structure(genital(penisColour, 1.8f), "corpora cavernosa of penis", corporaCavernosa()));
  addPair(list, genital(testisColour, 2.2f), "testis", testis());
  addPair(list, genital(seminalColour, 1.5f), "epididymis", epididymis());
  for (std::size_t i = outer; i < list.size(); ++i) {
    list[i].gamma = Gamma::clamped(1.4f);
    list[i].inkColour = genitalInk;
    if (list[i].name.starts_with("corpora"))
      list[i].smoothing = 0.8f;  // where the crura lie on the rami of the pubis
  }
  return list;
}

namespace {
/// The uterus is bent forward over the bladder: neck, isthmus, body, and the fundus between the
/// tubes.
Shape uterus() {
  Shape body = shapeOf(Band{{{x0, -72.2f, 869}, 9.6f, 8, {1, 0, 0}},
                            {{x0, -73.2f, 873}, 10.8f, 9, {1, 0, 0}},
                            {{x0, -75.7f, 880}, 12, 10, {1, 0, 0}},
                            {{x0, -80.5f, 888.5f}, 11.5f, 9, {1, 0, 0}},
                            {{x0, -89, 898}, 16.5f, 11.5f, {1, 0, 0}},
                            {{x0, -99, 905}, 23, 15, {1, 0, 0}},
                            {{x0, -106, 909}, 24.7f, 15.6f, {1, 0, 0}},
                            {{x0, -112, 911.5f}, 24.9f, 15.7f, {1, 0, 0}}});
  Shape horns = branching({Tube{{{x0 - 12, -108, 910}, 8}, {{x0 - 25, -109.5f, 912.5f}, 3.6f}},
                           Tube{{{x0 + 12, -108, 910}, 8}, {{x0 + 25, -109.5f, 912.5f}, 3.6f}}},
                          6.0f);
  return merged(std::move(body), std::move(horns), 8.0f);
}

/// The cavity is a slit between front and back wall, wide between the tubes, narrow at the isthmus,
/// wider again in the neck; open into the vagina.
Field uterineCavity() {
  return shapeOf(Band{{{x0, -70.9f, 852}, 4, 1.5f, {1, 0, 0}},
                      {{x0, -71.3f, 861}, 3.6f, 1.5f, {1, 0, 0}},
                      {{x0, -72.5f, 869}, 4.2f, 1.9f, {1, 0, 0}},
                      {{x0, -75, 878}, 3.4f, 1.7f, {1, 0, 0}},
                      {{x0, -80.5f, 888.5f}, 2.2f, 1.35f, {1, 0, 0}},
                      {{x0, -89, 898}, 4.5f, 1.6f, {1, 0, 0}},
                      {{x0, -100, 905.5f}, 9.5f, 1.9f, {1, 0, 0}},
                      {{x0, -109.5f, 910.2f}, 15, 2, {1, 0, 0}}})
      .field;
}

/// Returns a sheet of that thickness along the axis of the vagina, from its opening to the neck of
/// the uterus, flat from front to back.
Shape vaginalTube(float widthLess, float thickness) {
  const auto at = [&](float y, float z, float width) {
    return BandPoint{{x0, y, z}, width - widthLess, thickness, {1, 0, 0}};
  };
  const std::array<BandPoint, 8> through{
      at(-96.5f, 799, 9),     at(-94, 808, 9.5f),  at(-91.5f, 817, 10), at(-88, 826, 11),
      at(-82.5f, 838, 12.5f), at(-77, 849, 13.5f), at(-73.3f, 857, 14), at(-72, 861, 14)};
  return shapeOf(Band(through));
}

/// Returns the vault to which the vagina widens around the neck of the uterus, deeper behind.
Blob vault(float less) {
  return Blob({x0, -71.8f, 866}, {16.5f - less, 12.9f - less, 11.5f - less}, {-14, 0, 0});
}

DemoStructure vagina() {
  constexpr float wall = 2.7f;
  const glm::vec3 introitus(x0, -94, 808.5f);
  DemoStructure body = structure(
      genital(vaginaColour, 1.4f), "vagina",
      cutOff(merged(vaginalTube(0, 4.2f), shapeOf(vault(0)), 7.0f), introitus, {0, -0.3f, -0.95f}));
  // The cavity keeps more room around the uterus than the wall requires: the vault is a moat around
  // its mouth.
  const Shape slit = merged(vaginalTube(wall, 1.5f), shapeOf(vault(wall)), 5.0f);
  return withCavity(std::move(body), slit.field);
}

/// The urethra is short and straight, from the neck of the bladder to in front of the vagina.
DemoStructure femaleUrethra() {
  const auto along = [](float radius, float flare) {
    return shapeOf(Tube{{{x0, -101.7f, 858}, radius + flare},
                        {{x0, -102, 848}, radius + 0.3f * flare},
                        {{x0, -103.5f, 836}, radius},
                        {{x0, -106.5f, 825}, radius},
                        {{x0, -109.5f, 815}, radius},
                        {{x0, -112.5f, 804}, radius}});
  };
  return withCavity(structure(genital(urinaryColour, 0.9f), "urethra",
                              cutOff(along(3.4f, 0.6f), {x0, -110.5f, 811}, {0, -0.28f, -0.96f})),
                    along(1.25f, 1.4f).field);
}

/// The ovary is an almond with scars of past follicles; its ligament hangs from the horn of the
/// uterus.
Shape ovary() {
  Shape body =
      rippled(shapeOf(Blob({35.5f, -93, 911}, {7.5f, 10, 14}, {24, 12, -8})), 9.0f, 0.75f, 1.9f);
  Shape ligament = shapeOf(Tube{{{23, -104, 906.5f}, 1.6f},
                                {{27, -102, 903.5f}, 1.5f},
                                {{32, -97, 904}, 1.7f},
                                {{35, -94, 908}, 2}});
  return merged(std::move(body), std::move(ligament), 3.0f);
}

/// The tube runs from the horn outward and back over the ovary; the funnel's fringes hang around
/// its mouth.
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
  list.push_back(femaleUrethra());
  list.push_back(
      withCavity(structure(genital(uterusColour, 1.5f), "uterus", uterus()), uterineCavity()));
  list.push_back(vagina());
  addPair(list, genital(ovaryColour, 1.1f), "ovary", ovary());
  addPair(list, genital(uterusColour, 0.9f), "uterine tube", uterineTube());
  return list;
}

}  // namespace sline::model
