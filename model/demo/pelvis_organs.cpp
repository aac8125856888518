// SPDX-License-Identifier: Apache-2.0
// What a man's and a woman's pelvis share.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/demo/pelvis_bones.h"
#include "model/demo/pelvis_parts.h"

namespace sline::model {

namespace {
constexpr Colour gutColour{205, 150, 122};
constexpr Colour urinaryColour{226, 178, 96};
constexpr Colour tumourColour{196, 206, 88};

DemoStructure organ(const char* name, Colour colour, Shape shape, float edge) {
  Palette palette = organPalette;
  palette.colour = colour;
  palette.edge = edge;
  return structure(palette, name, std::move(shape));
}

/// Hollow, with that opening.
DemoStructure hollow(DemoStructure s, float wall, Field opening) {
  s.wall = wall;
  s.opening = std::move(opening);
  return s;
}

/// A fold across the wall: the valley that it draws on the outside, on the side of `towards`.
struct Fold {
  glm::vec3 position;
  glm::vec3 towards;
};

/// From the sigmoid colon along the sacrum (sacral flexure), over the pelvic floor (anorectal
/// flexure) to the anus; wider than deep, with three transverse folds on alternate sides.
Shape rectum(Sex sex) {
  const float back = sex == Sex::female ? 7.0f : 0.0f;  // room for the uterus
  const float slim = sex == Sex::female ? 0.86f : 1.0f;
  // In a space pressed together from side to side by a factor, so that round tubes come out wide.
  constexpr float wide = 1.2f;
  constexpr float x = 1.0f / wide;
  const std::vector<Tube> tubes{Tube{{{-1 * x, -46.5f, 815}, 7},
                                     {{-1 * x, -45, 824}, 9},
                                     {{-1.3f * x, -45, 835}, 13},
                                     {{-1.5f * x, -46, 850}, 17},
                                     {{-2.5f * x, -43, 866}, 17.5f},
                                     {{0, -38.5f, 882}, 19},
                                     {{4 * x, -37, 898}, 20},
                                     {{5 * x, -38, 910}, 20}},
                                Tube{{{4 * x, -41, 900}, 20 * slim},
                                     {{4 * x, -46 + 0.5f * back, 913}, 22.5f * slim},
                                     {{4 * x, -54 + back, 921}, 24.5f * slim},
                                     {{4 * x, -60 + back, 923}, 23 * slim}}};
  Box box = boundsOf(std::span<const Tube>(tubes));
  box.low.x *= wide;
  box.high.x *= wide;
  const Field field = [tubes](const glm::vec3& p) {
    static constexpr Fold folds[]{{{-14, -40, 857}, {1, 0.1f, 0.25f}},
                                  {{10, -37, 876}, {-1, 0.1f, 0.15f}},
                                  {{-8, -37, 901}, {1, -0.2f, 0.4f}}};
    float d = blended(std::span<const Tube>(tubes), {p.x / wide, p.y, p.z}, 14.0f);
    if (std::abs(d) > 8.0f)
      return d;
    for (const auto& [position, towards] : folds) {
      const glm::vec3 q = p - position;
      const float across = 0.22f * (q.z - 0.2f * std::abs(q.x) + 0.1f * q.y);
      const float side = 1.0f / (1.0f + std::exp(0.25f * glm::dot(q, towards)));
      d += 2.4f * side * std::exp(-across * across);
    }
    return d - 0.5f * wave(p, 34.0f, 0.4f);
  };
  return cutOff({field, box}, {-1, -46.5f, 811}, {0, 0.1f, -1});
}

/// Haustra between creases that three bands of muscle interrupt.
Shape sigmoid(Sex sex) {
  const float back = sex == Sex::female ? 7.0f : 0.0f;
  const std::vector<TubePoint> through{
      {{4, -56 + back, 924}, 17}, {{7, -70 + back, 936}, 17.5f}, {{14, -89, 947}, 17.5f},
      {{27, -110, 951}, 17.5f},   {{46, -128, 949}, 17.5f},      {{68, -140, 948}, 18},
      {{89, -143, 956}, 18.5f},   {{103, -139, 974}, 19},        {{107, -132, 996}, 19.5f},
      {{107, -127, 1016}, 19.5f}, {{106, -124, 1040}, 19.5f}};
  std::vector<Curve::Knot> knots;
  Box box;
  float along = 0.0f;
  for (std::size_t i = 0; i < through.size(); ++i) {
    const auto& [position, radius] = through[i];
    along += i > 0 ? glm::distance(position, through[i - 1].position) : 0.0f;
    knots.push_back({glm::vec4(position, radius), glm::vec4(along, 0, 0, 0)});
    box.add(position - radius);
    box.add(position + radius);
  }
  Shape body{[curve = Curve(knots, 4.0f), bounds = grown(box, 3.0f)](const glm::vec3& p) {
               if (const float outside = distanceToBox(bounds, p); outside > 12.0f)
                 return outside;
               const Curve::Place place = curve.nearest(p, 0.0f);
               const glm::vec3 away = p - glm::vec3(place.main);
               const float d = glm::length(away) - place.main.w;
               if (std::abs(d) > 9.0f)
                 return d;
               const glm::vec3 side = glm::normalize(glm::cross(place.tangent, {0.3f, 0.5f, 0.8f}));
               const float angle = std::atan2(glm::dot(away, glm::cross(place.tangent, side)),
                                              glm::dot(away, side));
               // Creases are no rings: each third of the wall has its own, a little shifted.
               const float third = std::cos(1.5f * (angle + 0.02f * place.more.x));
               const float phase = place.more.x / 17.0f + 0.22f * std::sin(2.0f * angle + 1.0f);
               const float crease =
                   2.4f * std::sin(3.14159265f * phase) * std::sin(3.14159265f * phase);
               const float depth = 3.6f * third * third;
               const float outer =
                   d + depth * std::exp(-1.6f * crease) + 1.1f * std::exp(-14.0f * third * third);
               return outer;
             },
             box};
  return body;
}

/// Half full: a rounded body, the apex forward over the pubis, the neck down to the urethra.
Shape bladder(Sex sex) {
  const float x = pelvisMiddle - 0.6f;
  const bool male = sex == Sex::male;
  const std::vector<Blob> parts =
      male ? std::vector<Blob>{Blob({x, -92, 880}, {35, 26, 18}, {-6, 0, 0}),
                               Blob({x, -113, 883}, {19, 24, 9}, {-4, 0, 0}),
                               Blob({x, -91, 866}, {17, 14, 8.5f})}
           : std::vector<Blob>{Blob({x, -104, 868}, {32, 24, 15}, {-10, 0, 0}),
                               Blob({x, -121, 873}, {18, 19, 8}, {-8, 0, 0}),
                               Blob({x, -99, 856}, {14, 12, 8})};
  return rippled(
      {[parts](const glm::vec3& p) { return blended(std::span<const Blob>(parts), p, 15.0f); },
       boundsOf(std::span<const Blob>(parts))},
      48.0f, 0.7f, 2.2f);
}

/// The anus, drawn together by the sphincter.
Field anus() {
  return shapeOf(Tube{{{-1, -46.5f, 806}, 4},
                      {{-1, -46, 815}, 2.6f},
                      {{-1, -45.5f, 824}, 2.4f},
                      {{-1, -45, 832}, 3.5f}})
      .field;
}

/// Of the urethra, from inside.
Field innerOrifice(Sex sex) {
  const float x = pelvisMiddle - 0.6f;
  const glm::vec3 neck = sex == Sex::male ? glm::vec3(x, -90.5f, 856) : glm::vec3(x, -100, 847);
  return shapeOf(Tube{{neck + glm::vec3(0, 0, -4), 2.4f},
                      {neck + glm::vec3(0, 0, 4), 2.4f},
                      {neck + glm::vec3(0, 0, 11), 4}})
      .field;
}

/// Over the iliac vessels, down the side wall of the pelvis, forward and inward to the bladder.
Shape leftUreter(Sex sex) {
  const glm::vec3 end = sex == Sex::male ? glm::vec3(21, -82, 879) : glm::vec3(21, -96, 868);
  return cutOff(shapeOf(Tube{{{31.5f, -122, 1060}, 2.3f},
                             {{31, -123, 1040}, 2.3f},
                             {{31, -127.5f, 1018}, 2.3f},
                             {{31, -129.5f, 998}, 2.3f},
                             {{32, -122, 978}, 2.4f},
                             {{35, -104, 957}, 2.2f},
                             {{38.5f, -82, 937}, 2.3f},
                             {{42, -72.5f, 918}, 2.3f},
                             {{38, -73.5f, 899}, 2.3f},
                             {{30, -76, 889}, 2.2f},
                             {end, 2}}),
                {31, -123, 1046}, {0, 0, 1});
}

Shape rightUreter(Sex sex) {
  const glm::vec3 end = sex == Sex::male ? glm::vec3(-23, -84, 878) : glm::vec3(-23, -98, 867);
  return cutOff(shapeOf(Tube{{{-34.5f, -115, 1060}, 2.3f},
                             {{-35, -117, 1040}, 2.3f},
                             {{-36.5f, -124, 1016}, 2.3f},
                             {{-36, -129, 995}, 2.3f},
                             {{-36.5f, -121, 975}, 2.4f},
                             {{-37.5f, -102, 956}, 2.2f},
                             {{-40.1f, -82, 937}, 2.3f},
                             {{-43.6f, -72.5f, 918}, 2.3f},
                             {{-39.8f, -74, 900}, 2.3f},
                             {{-31.5f, -77, 889}, 2.2f},
                             {end, 2}}),
                {-35, -118, 1046}, {0, 0, 1});
}

/// A cauliflower in the wall of the upper rectum, right in front.
Shape tumour(Sex sex) {
  const glm::vec3 shift = sex == Sex::female ? glm::vec3(-2, 12, 6) : glm::vec3(0);
  const std::vector<Blob> lobes{Blob(shift + glm::vec3(-13, -75, 921), {12, 9, 11}),
                                Blob(shift + glm::vec3(-21, -74, 927), {7.5f, 7, 6.5f}),
                                Blob(shift + glm::vec3(-5, -80, 925), {7, 6.5f, 7.5f}),
                                Blob(shift + glm::vec3(-14, -81, 929), {7, 6, 6}),
                                Blob(shift + glm::vec3(-19, -79, 915), {7.5f, 6.5f, 6.5f}),
                                Blob(shift + glm::vec3(-9, -81, 914), {6.5f, 6, 6.5f}),
                                Blob(shift + glm::vec3(-25, -71, 919), {5.5f, 6, 6})};
  Shape body{[lobes](const glm::vec3& p) { return blended(std::span<const Blob>(lobes), p, 3.5f); },
             boundsOf(std::span<const Blob>(lobes))};
  return rippled(rippled(std::move(body), 9.0f, 0.7f, 0.9f), 5.5f, 0.25f, 2.0f);
}
}  // namespace

std::vector<DemoStructure> pelvisOrgans(Sex sex) {
  std::vector<DemoStructure> list;
  list.push_back(
      hollow(organ("urinary bladder", urinaryColour, bladder(sex), 2.2f), 4.0f, innerOrifice(sex)));
  list.push_back(organ("left ureter", urinaryColour, leftUreter(sex), 1.3f));
  list.push_back(organ("right ureter", urinaryColour, rightUreter(sex), 1.3f));
  list.push_back(hollow(organ("rectum", gutColour, rectum(sex), 2.2f), 4.0f, anus()));
  // The descending colon would follow at the iliac crest.
  list.push_back(hollow(organ("sigmoid colon", gutColour, sigmoid(sex), 2.3f), 3.5f,
                        [](const glm::vec3& p) { return 1028.0f - p.z - 0.1f * (p.y + 126.0f); }));
  DemoStructure mass = organ("rectal tumour", tumourColour, tumour(sex), 1.2f);
  mass.groups = {"Tumour"};
  mass.gamma = Gamma::clamped(5.0f);
  list.push_back(std::move(mass));
  return list;
}

}  // namespace sline::model
