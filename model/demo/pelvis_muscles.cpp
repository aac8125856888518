// SPDX-License-Identifier: Apache-2.0
// Left muscles, mirrored to the right. Nets of the flat ones run from origin to insertion row by
// row, from front to back within a row.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/demo/pelvis_bones.h"
#include "model/demo/pelvis_parts.h"

namespace sline::model {

namespace {
/// A fan on the inner face of the obturator membrane; its tendon turns around the lesser sciatic
/// notch to the greater trochanter.
Shape obturatorInternus() {
  Shape fan = shapeOf(Lamina({{{30, -114, 857}, 2},
                              {{35, -115, 868}, 2.5f},
                              {{41, -113, 879}, 2},
                              {{28, -101, 846}, 3},
                              {{38, -101, 866}, 5},
                              {{49, -99, 889}, 3},
                              {{34, -85, 841}, 3},
                              {{45, -85, 866}, 6},
                              {{55, -83, 892}, 3.2f},
                              {{41, -68, 841}, 3},
                              {{49, -67, 865}, 6},
                              {{55, -66, 886}, 3},
                              {{48, -52, 850}, 3},
                              {{51, -51, 862}, 5.5f},
                              {{53, -50, 875}, 3},
                              {{52, -43, 861}, 3},
                              {{52.5f, -42, 866}, 4.5f},
                              {{53, -42, 871}, 3}},
                             3));
  Shape tendon = shapeOf(Band{{{51, -47, 865}, 8, 4.5f, {0, 0, 1}},
                              {{55, -40, 867}, 7.5f, 4.2f, {0, 0, 1}},
                              {{65, -39, 870}, 6.2f, 4, {0, 0, 1}},
                              {{80, -45, 870}, 5, 3.8f, {0, 0, 1}},
                              {{100, -57, 868}, 4, 3.4f, {0, 0, 1}},
                              {{116, -68, 866}, 3.2f, 3, {0, 0, 1}},
                              {{125, -75, 864}, 2.8f, 2.6f, {0, 0, 1}}});
  return merged(std::move(fan), std::move(tendon), 6.0f);
}

/// From the ischial spine to the side of the last sacral and the coccygeal vertebrae.
Shape coccygeus() {
  return shapeOf(Lamina({{{49, -41, 894}, 2},
                         {{49.5f, -41, 891}, 2.2f},
                         {{48, -40, 888}, 2},
                         {{39, -31, 896}, 2},
                         {{39, -31, 888}, 2.5f},
                         {{36, -31, 880}, 1.8f},
                         {{25, -21, 896.5f}, 1.8f},
                         {{25, -21, 885}, 2.4f},
                         {{21, -21, 869}, 1.6f},
                         {{9, -15, 896}, 1.5f},
                         {{8, -15, 879}, 1.8f},
                         {{5, -17, 859}, 1.4f}},
                        3));
}

/// From the tendinous arch of the obturator fascia to the raphe behind the anus and the coccyx.
Shape iliococcygeus() {
  return shapeOf(Lamina({{{36, -94, 856}, 1.3f},
                         {{41, -79, 863}, 1.5f},
                         {{48, -62, 875}, 1.6f},
                         {{49.5f, -46, 888}, 1.6f},
                         {{41, -32, 880}, 1.5f},
                         {{23, -22, 864}, 1.3f},
                         {{34, -89, 852}, 1.3f},
                         {{37, -75, 856}, 1.6f},
                         {{41, -60, 863}, 1.8f},
                         {{40, -45, 868}, 1.8f},
                         {{30, -31, 863}, 1.7f},
                         {{12, -22, 857}, 1.4f},
                         {{32, -84, 850}, 1.3f},
                         {{32, -71, 851}, 1.5f},
                         {{31, -57, 851}, 1.6f},
                         {{26, -43, 848}, 1.6f},
                         {{14, -31, 846}, 1.6f},
                         {{2, -24, 848}, 1.4f}},
                        6));
}

/// From the back of the pubis past the prostate or vagina and the rectum to the coccyx.
Shape pubococcygeus() {
  return shapeOf(
      Lamina({{{24, -109, 855}, 1.4f},   {{32, -96, 857}, 1.5f},       {{35.5f, -80, 860.5f}, 1.6f},
              {{33, -62, 862}, 1.6f},    {{31, -45, 863}, 1.6f},       {{24, -28, 867}, 1.5f},
              {{12, -16, 877}, 1.3f},    {{18, -109, 848}, 1.4f},      {{24, -95, 846}, 1.7f},
              {{27, -78, 847}, 1.8f},    {{26.5f, -61, 847}, 1.8f},    {{25, -44, 850}, 1.8f},
              {{18, -29, 857}, 1.6f},    {{9, -17, 869}, 1.4f},        {{12.5f, -108, 843}, 1.4f},
              {{14, -92, 838}, 1.6f},    {{15, -76, 835.5f}, 1.7f},    {{16, -60, 833.5f}, 1.7f},
              {{16, -45, 838.5f}, 1.7f}, {{10.5f, -30, 848.5f}, 1.6f}, {{5, -19, 862}, 1.4f}},
             7));
}

/// The lowest sling: from the pubis around the anorectal junction, met by its fellow behind it.
Shape puborectalis() {
  return shapeOf(Band{{{19, -111.5f, 847}, 8.5f, 1.8f, {0.72f, 0, 0.7f}},
                      {{24.5f, -97, 845.5f}, 12, 2.2f, {0.6f, 0, 0.8f}},
                      {{25, -80, 843}, 12.5f, 2.4f, {0.55f, 0, 0.83f}},
                      {{24, -62, 840}, 12, 2.6f, {0.5f, 0, 0.86f}},
                      {{20.5f, -45, 837.5f}, 10.5f, 2.8f, {0.4f, 0, 0.9f}},
                      {{13.5f, -32, 837.5f}, 9.5f, 3, {0.2f, -0.2f, 1}},
                      {{5.5f, -27.5f, 838}, 8.5f, 2.6f, {0, -0.2f, 1}}});
}

/// From the front of the sacrum through the greater sciatic foramen to the greater trochanter.
Shape piriformis() {
  Shape belly = shapeOf(Band{{{22, -23, 929}, 13, 3.5f, {0.3f, 0.1f, 1}},
                             {{36, -19, 925}, 14, 5.5f, {0.35f, 0.1f, 1}},
                             {{54, -18, 916}, 13, 7, {0.45f, 0.1f, 1}},
                             {{76, -26, 904}, 10.5f, 7, {0.5f, 0.1f, 1}},
                             {{100, -43, 894}, 7.5f, 5.5f, {0.5f, 0, 1}},
                             {{122, -62, 888}, 4.6f, 3.8f, {0.4f, 0, 1}},
                             {{138, -76, 885}, 3, 2.6f, {0.3f, 0, 1}}});
  // Three slips between the sacral foramina.
  Shape slips =
      branching({Tube{{{17, -28, 937}, 3.2f}, {{28, -24, 932}, 4.5f}, {{40, -20, 925}, 5}},
                 Tube{{{15, -19, 921}, 3}, {{27, -19, 919}, 4.2f}, {{40, -18, 917}, 5}}},
                5.0f);
  return merged(std::move(belly), std::move(slips), 5.0f);
}

Shape psoasMajor() {
  return cutOff(shapeOf(Band{{{41, -76, 1052}, 12, 11, {0.8f, -0.6f, 0}},
                             {{43, -80, 1036}, 13, 11.5f, {0.8f, -0.6f, 0}},
                             {{47, -88, 1014}, 13.5f, 12, {0.8f, -0.6f, 0}},
                             {{54, -98, 990}, 14, 12, {0.8f, -0.6f, 0}},
                             {{63, -108, 966}, 14, 11.5f, {0.85f, -0.5f, 0}},
                             {{72, -117, 942}, 13, 10.5f, {0.9f, -0.4f, 0}},
                             {{79, -125, 920}, 11.5f, 9.5f, {1, -0.3f, 0}},
                             {{83, -130, 900}, 10, 8.5f, {1, -0.2f, 0}},
                             {{85.5f, -127, 880}, 8, 7.5f, {1, 0, 0}},
                             {{89, -116, 862}, 6, 6, {1, 0, 0}},
                             {{93, -103, 849}, 4.5f, 4.5f, {1, 0, 0}}}),
                {42, -78, 1044}, {0, 0, 1});
}

/// The fan in the iliac fossa, narrowing beside the psoas over the hip joint.
Shape iliacus() {
  return shapeOf(
      Lamina({{{76, -63, 1020}, 2.5f},     {{97, -78, 1021}, 3},      {{116, -96, 1019}, 3},
              {{131, -113, 1012}, 2.5f},   {{69, -66, 1000}, 4},      {{92, -80, 1000}, 5.5f},
              {{112, -94, 1000}, 5.5f},    {{128, -118, 996}, 3},     {{68, -74, 980}, 4.5f},
              {{88, -84, 980}, 7},         {{105, -97, 980}, 7},      {{122, -119, 978}, 3.5f},
              {{72, -84, 960}, 5},         {{86, -91, 960}, 7.5f},    {{101, -105, 960}, 7.5f},
              {{115, -122, 958}, 4},       {{79, -96, 938}, 5},       {{88, -103, 938}, 7.5f},
              {{97, -112, 938}, 7.5f},     {{107, -122, 938}, 4.5f},  {{87, -113, 914}, 5},
              {{92, -118, 914}, 7},        {{98, -122, 914}, 7},      {{104, -127, 914}, 5},
              {{91, -128, 890}, 4.5f},     {{94.5f, -129, 890}, 6},   {{98, -130, 890}, 6},
              {{101.5f, -131, 890}, 4.5f}, {{92, -122, 868}, 3.5f},   {{94.5f, -122, 868}, 4},
              {{97, -122, 868}, 4},        {{99.5f, -122, 868}, 3.5f}},
             4));
}

/// An oval ring around the anal canal, drawn out to the coccyx behind.
Shape analSphincter() {
  const glm::vec3 centre(pelvisMiddle, -44, 823);
  const Field ring = [centre](const glm::vec3& p) {
    const glm::vec3 q = p - centre;
    // An egg with its point to the back: narrower there, wider in front.
    const float tail = std::max(q.y, 0.0f);
    const glm::vec3 oval(q.x * (1.0f + 0.012f * tail), q.y * 0.78f, q.z + 0.12f * q.y);
    const float around = std::hypot(oval.x, oval.y) - 13.5f;
    const float waist = 1.0f - 0.1f * std::sin(0.55f * oval.z);
    return ellipsoid({around, 0.0f, oval.z}, {4.4f * waist, 4.4f, 9.5f});
  };
  return {ring, {centre - glm::vec3(20, 26, 13), centre + glm::vec3(20, 26, 14)}};
}
}  // namespace

std::vector<DemoStructure> pelvisMuscles() {
  std::vector<DemoStructure> list;
  addPair(list, musclePalette, "puborectalis", puborectalis());
  addPair(list, musclePalette, "pubococcygeus", pubococcygeus());
  addPair(list, musclePalette, "iliococcygeus", iliococcygeus());
  addPair(list, musclePalette, "coccygeus", coccygeus());
  addPair(list, musclePalette, "obturator internus", obturatorInternus());
  addPair(list, musclePalette, "piriformis", piriformis());
  addPair(list, musclePalette, "psoas major", psoasMajor());
  addPair(list, musclePalette, "iliacus", iliacus());
  list.push_back(structure(musclePalette, "external anal sphincter", analSphincter()));
  return list;
}

}  // namespace sline::model
