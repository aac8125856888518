// SPDX-License-Identifier: Apache-2.0
// Models the organs that a man's and a woman's pelvis share.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/demo/pelvis/bones.h"
#include "model/demo/pelvis/parts.h"

namespace sline::model {

namespace {
constexpr Colour gutColour{205, 150, 122};
constexpr Colour tumourColour{128, 96, 146};

DemoStructure organ(const char* name, Colour colour, Shape shape, float edge) {
  Palette palette = organPalette;
  palette.colour = colour;
  palette.edge = edge;
  return structure(palette, name, std::move(shape));
}

/// Makes the structure hollow, with that wall and opening.
DemoStructure hollow(DemoStructure s, float wall, Field opening) {
  s.wall = wall;
  s.opening = std::move(opening);
  return s;
}

/// Describes a fold across the wall by the valley that it draws on the outside, on the side of
/// `towards`.
struct Fold {
  glm::vec3 position;
  glm::vec3 towards;
};

/// Returns the middle of the tumour, in the front wall of the upper rectum.
glm::vec3 tumourMiddle(Sex sex) {
  return sex == Sex::female ? glm::vec3(-8, -62, 919) : glm::vec3(-7, -72.5f, 914);
}

/// The tumour is a cauliflower that has grown through the wall.
Shape tumour(Sex sex) {
  const glm::vec3 m = tumourMiddle(sex);
  const std::vector<Blob> lobes{Blob(m, {12, 10, 11}),
                                Blob(m + glm::vec3(-8, 1, 6), {7.5f, 7, 6.5f}),
                                Blob(m + glm::vec3(8, -5, 4), {7, 6.5f, 7.5f}),
                                Blob(m + glm::vec3(-1, -6, 8), {7, 6, 6}),
                                Blob(m + glm::vec3(-6, -4, -6), {7.5f, 6.5f, 6.5f}),
                                Blob(m + glm::vec3(4, -6, -7), {6.5f, 6, 6.5f}),
                                Blob(m + glm::vec3(-11, 5, -2), {6, 6.5f, 6}),
                                Blob(m + glm::vec3(1, 9, -3), {8, 6, 7}),
                                Blob(m + glm::vec3(6, 8, 3), {6, 5.5f, 6}),
                                Blob(m + glm::vec3(-6, 9, 3), {6, 5.5f, 5.5f})};
  Shape body{[lobes](const glm::vec3& p) { return blended(std::span<const Blob>(lobes), p, 3.5f); },
             boundsOf(std::span<const Blob>(lobes))};
  return rippled(std::move(body), 9.0f, 0.5f, 0.9f);
}

/// Returns the lumen around the tumour, as wide as without it: the tumour does not push the wall
/// outwards, so it lies open in the bowel.
Field lumenAtTumour(Sex sex, Field lumen) {
  return [m = tumourMiddle(sex), lumen = std::move(lumen)](const glm::vec3& p) {
    const float away = glm::distance(p, m) - 23.0f;
    return away > 6.0f ? away : std::max(away, lumen(p));
  };
}

/// Returns the anus, which the sphincter draws together.
Field anus() {
  return shapeOf(Tube{{{-1, -46.5f, 806}, 4},
                      {{-1, -46, 815}, 2.6f},
                      {{-1, -45.5f, 824}, 2.4f},
                      {{-1, -45, 832}, 3.5f}})
      .field;
}

/// Holds where the sigmoid colon continues as the rectum, and the direction onward.
struct Junction {
  glm::vec3 point;
  glm::vec3 onward;
};
Junction rectosigmoid(Sex sex) {
  const float back = sex == Sex::female ? 7.0f : 0.0f;  // room for the uterus
  return {{5, -68 + back, 929.5f}, {0.12f, -0.76f, 0.64f}};
}

/// The rectum runs from the sigmoid colon along the sacrum (sacral flexure), over the pelvic floor
/// (anorectal flexure) to the anus; it is wider than deep, with three transverse folds on alternate
/// sides. It continues beyond the junction and the anus.
Shape rectalCourse(Sex sex) {
  const float back = sex == Sex::female ? 7.0f : 0.0f;
  const float slim = sex == Sex::female ? 0.82f : 1.0f;
  // The tube lies in a space compressed from side to side by this factor, so that round tubes come
  // out wide.
  constexpr float wide = 1.2f;
  constexpr float x = 1.0f / wide;
  const Tube tube{{{-1 * x, -46.8f, 806}, 7},
                  {{-1 * x, -46, 817}, 7.6f},
                  {{-1.1f * x, -45.2f, 827}, 9.8f},
                  {{-1.3f * x, -45.2f + 0.2f * back, 838}, 13.8f * slim},
                  {{-1.7f * x, -45 + 0.45f * back, 851}, 16.8f * slim},
                  {{-2.2f * x, -42.5f + 0.45f * back, 866}, 18 * slim},
                  {{0, -39 + 0.3f * back, 882}, 19 * slim},
                  {{3.5f * x, -39 + 0.3f * back, 899}, 20.5f * slim},
                  {{4.5f * x, -45 + 0.6f * back, 914}, 23.8f * slim},
                  {{5 * x, -56.5f + back, 923.3f}, 22.6f * slim},
                  {{5 * x, -68 + back, 929.5f}, 20.3f * slim},
                  {{6 * x, -80 + back, 937.5f}, 19 * slim}};
  Box box = tube.bounds();
  box.low.x *= wide;
  box.high.x *= wide;
  const Field field = [tube](const glm::vec3& p) {
    static constexpr Fold folds[]{{{-14, -40, 857}, {1, 0.1f, 0.25f}},
                                  {{10, -37, 876}, {-1, 0.1f, 0.15f}},
                                  {{-8, -37, 901}, {1, -0.2f, 0.4f}}};
    float d = tube.distance({p.x / wide, p.y, p.z});
    if (std::abs(d) > 9.0f)
      return d;
    for (const auto& [position, towards] : folds) {
      const glm::vec3 q = p - position;
      const float across = 0.17f * (q.z - 0.006f * q.x * q.x + 0.1f * q.y);
      const float side = 1.0f / (1.0f + std::exp(0.2f * glm::dot(q, towards)));
      d += 2.4f * side * std::exp(-across * across);
    }
    return d;
  };
  return {field, box};
}

constexpr float rectalWall = 4.0f;

DemoStructure rectum(Sex sex) {
  const Shape course = rectalCourse(sex);
  const Junction up = rectosigmoid(sex);
  const auto lumen = [course = course.field](const glm::vec3& p) { return course(p) + rectalWall; };
  const Field end = beyondPlane(up.point - 5.0f * up.onward, up.onward, 40.0f);

  DemoStructure body =
      organ("rectum", gutColour,
            cutOff(cutOff(course, {-1, -46.5f, 811}, {0, 0.1f, -1}), up.point, up.onward), 2.2f);
  body.wall = rectalWall;
  body.rounding = 0.6f;
  body.opening = anyOf({anus(),
                        [lumen, end](const glm::vec3& p) {
                          const float d = end(p);
                          return d > 6.0f ? d : std::max(d, lumen(p));
                        },
                        lumenAtTumour(sex, lumen)});
  return body;
}

/// The sigmoid colon has haustra between creases that three bands of muscle interrupt. It continues
/// beyond both its ends.
Shape sigmoidCourse(Sex sex) {
  const Junction from = rectosigmoid(sex);
  const float back = sex == Sex::female ? 7.0f : 0.0f;
  const std::vector<TubePoint> through{{from.point - 12.0f * from.onward, 21},
                                       {from.point, 19.5f},
                                       {{9, -80 + 0.7f * back, 938.5f}, 18.5f},
                                       {{16, -94 + 0.2f * back, 945.5f}, 17.5f},
                                       {{28, -114, 945.5f}, 17.3f},
                                       {{47, -129.5f, 946.5f}, 17.5f},
                                       {{68, -140, 947.5f}, 18},
                                       {{88, -142, 957}, 18.5f},
                                       {{101, -138, 974}, 19},
                                       {{106, -132, 995}, 19.5f},
                                       {{107, -127.5f, 1017}, 19.5f},
                                       {{106, -124, 1042}, 19.5f}};
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
  const auto wall = [curve = Curve(knots, 4.0f), bounds = grown(box, 3.0f)](const glm::vec3& p) {
    if (const float outside = distanceToBox(bounds, p); outside > 12.0f)
      return outside;
    const Curve::Place place = curve.nearest(p, 0.0f);
    const glm::vec3 away = p - glm::vec3(place.main);
    const float d = glm::length(away) - place.main.w;
    if (std::abs(d) > 9.0f)
      return d;
    const glm::vec3 side = glm::normalize(glm::cross(place.tangent, {0.3f, 0.5f, 0.8f}));
    const float angle =
        std::atan2(glm::dot(away, glm::cross(place.tangent, side)), glm::dot(away, side));
    // The creases are no rings: each third of the wall has its own, a little shifted. Towards the
    // rectum both creases and bands fade.
    const float third = std::cos(1.5f * (angle + 0.015f * place.more.x));
    const float phase = place.more.x / 19.0f + 0.2f * std::sin(2.0f * angle + 1.0f);
    const float crease = 1.9f * std::sin(3.14159265f * phase) * std::sin(3.14159265f * phase);
    const float fade = glm::smoothstep(8.0f, 45.0f, place.more.x);
    return d + fade * (3.4f * third * third * std::exp(-1.5f * crease) +
                       1.0f * std::exp(-8.0f * third * third));
  };
  return {wall, box};
}

DemoStructure sigmoidColon(Sex sex) {
  constexpr float wall = 3.5f;
  const Shape course = sigmoidCourse(sex);
  const Junction from = rectosigmoid(sex);
  // The descending colon would follow at the iliac crest.
  const glm::vec3 top(107, -126, 1028);
  const glm::vec3 up(0, 0.1f, 1);
  DemoStructure body =
      organ("sigmoid colon", gutColour,
            cutOff(cutOff(course, from.point + 0.1f * from.onward, -from.onward), top, up), 2.2f);
  body.box.high.z = top.z + 8.0f;
  body.wall = wall;
  const Field ends = anyOf({beyondPlane(from.point + 4.5f * from.onward, -from.onward, 40.0f),
                            beyondPlane(top - 4.5f * up, up, 60.0f)});
  body.rounding = 0.6f;
  const Field lumen = [course = course.field](const glm::vec3& p) { return course(p) + wall; };
  const auto atEnds = [ends, lumen](const glm::vec3& p) {
    const float d = ends(p);
    return d > 6.0f ? d : std::max(d, lumen(p));
  };
  body.opening = anyOf({atEnds, lumenAtTumour(sex, lumen)});
  return body;
}

/// The bladder is half full: a rounded body, the apex forward over the pubis, the neck down to the
/// urethra.
Shape bladder(Sex sex) {
  const float x = pelvisMiddle - 0.6f;
  const bool male = sex == Sex::male;
  const std::vector<Blob> parts =
      male ? std::vector<Blob>{Blob({x, -92, 880}, {35, 26, 18}, {-6, 0, 0}),
                               Blob({x, -111, 882}, {21, 25, 11}, {-4, 0, 0}),
                               Blob({x, -91, 866}, {17, 14, 8.5f})}
           : std::vector<Blob>{Blob({x, -108.5f, 868.5f}, {32, 23, 14.5f}, {-10, 0, 0}),
                               Blob({x, -122, 875}, {19, 19, 9}, {-10, 0, 0}),
                               Blob({x, -101, 857}, {14, 12, 8})};
  return rippled(
      {[parts](const glm::vec3& p) { return blended(std::span<const Blob>(parts), p, 15.0f); },
       boundsOf(std::span<const Blob>(parts))},
      48.0f, 0.7f, 2.2f);
}

/// Returns the inner orifice of the urethra, seen from inside the bladder.
Field innerOrifice(Sex sex) {
  const float x = pelvisMiddle - 0.6f;
  const glm::vec3 neck =
      sex == Sex::male ? glm::vec3(x, -90.5f, 856) : glm::vec3(x, -101.5f, 847.5f);
  return shapeOf(Tube{{neck + glm::vec3(0, 0, -4), 2.4f},
                      {neck + glm::vec3(0, 0, 4), 2.4f},
                      {neck + glm::vec3(0, 0, 11), 4}})
      .field;
}

/// The ureter runs over the iliac vessels, down the side wall of the pelvis, forward and inward to
/// the bladder.
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

}  // namespace

std::vector<DemoStructure> pelvisOrgans(Sex sex) {
  std::vector<DemoStructure> list;
  list.push_back(
      hollow(organ("urinary bladder", urinaryColour, bladder(sex), 2.2f), 4.0f, innerOrifice(sex)));
  list.push_back(organ("left ureter", urinaryColour, leftUreter(sex), 1.3f));
  list.push_back(organ("right ureter", urinaryColour, rightUreter(sex), 1.3f));
  list.push_back(rectum(sex));
  list.push_back(sigmoidColon(sex));
  DemoStructure mass = organ("rectal tumour", tumourColour, tumour(sex), 1.2f);
  mass.groups = {"Tumour"};
  mass.gamma = Gamma::clamped(4.7f);
  list.push_back(std::move(mass));
  return list;
}

}  // namespace sline::model
