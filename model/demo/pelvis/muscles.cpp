// SPDX-License-Identifier: Apache-2.0
// Models the left muscles, which are mirrored to the right. Nets of the flat ones run from origin
// to insertion row by row, from front to back within a row.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/demo/pelvis/bones.h"
#include "model/demo/pelvis/parts.h"

namespace sline::model {

namespace {
/// The muscle is a fan on the inner face of the obturator membrane; its tendon turns around the
/// lesser sciatic notch to the greater trochanter.
Shape obturatorInternus() {
  Shape fan = smoothed(Lamina({{{30, -114, 857}, 2},
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
                              3),
                       1.8f);
  Shape tendon = shapeOf(Band{{{51, -47, 865}, 8, 4.5f, {0, 0, 1}},
                              {{54.5f, -38.5f, 867}, 7.5f, 4.2f, {0, 0, 1}},
                              {{64, -35.5f, 870}, 6.2f, 4, {0, 0, 1}},
                              {{80, -40.5f, 871}, 5, 3.8f, {0, 0, 1}},
                              {{100, -54, 869}, 4.2f, 3.4f, {0, 0, 1}},
                              {{116, -66, 867}, 3.4f, 3, {0, 0, 1}},
                              {{128, -71, 866}, 2.8f, 2.6f, {0, 0, 1}},
                              {{138, -74, 866}, 2.8f, 2.6f, {0, 0, 1}}});
  return merged(std::move(fan), std::move(tendon), 6.0f);
}

/// The muscle runs from the ischial spine to the side of the last sacral and the coccygeal
/// vertebrae.
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

/// The muscle runs from the tendinous arch of the obturator fascia to the raphe behind the anus and
/// the coccyx.
Shape iliococcygeus() {
  return shapeOf(Lamina({{{37, -94, 859}, 1.2f},
                         {{42, -79, 865}, 1.4f},
                         {{48.5f, -62, 875.5f}, 1.5f},
                         {{50, -46, 889}, 1.5f},
                         {{42, -31, 881}, 1.4f},
                         {{24, -20.5f, 864}, 1.2f},
                         {{36.5f, -89, 857}, 1.2f},
                         {{39, -75, 860}, 1.4f},
                         {{42, -60, 865}, 1.6f},
                         {{41, -44, 868}, 1.6f},
                         {{31, -29.5f, 862}, 1.5f},
                         {{13, -20.5f, 856}, 1.2f},
                         {{36, -84, 855.5f}, 1.2f},
                         {{36, -71, 856}, 1.3f},
                         {{34.5f, -57, 855.5f}, 1.4f},
                         {{28, -42, 849}, 1.4f},
                         {{16, -28.5f, 846}, 1.3f},
                         {{2, -22, 846.5f}, 1.2f}},
                        6));
}

/// The muscle runs from the back of the pubis past the prostate or vagina and the rectum to the
/// coccyx; it lies on the iliococcygeus from above.
Shape pubococcygeus() {
  return shapeOf(Lamina(
      {{{28, -109, 858}, 1.1f},   {{32, -96, 860}, 1.2f},       {{35, -80, 863}, 1.2f},
       {{33, -62, 865.5f}, 1.2f}, {{30, -46, 868}, 1.2f},       {{23, -30.5f, 874}, 1.2f},
       {{13, -18.5f, 883}, 1.1f}, {{24, -109, 853}, 1.1f},      {{27, -95, 853}, 1.2f},
       {{29, -78, 854}, 1.3f},    {{28, -61, 855}, 1.3f},       {{25, -46, 858}, 1.3f},
       {{17, -32, 865}, 1.2f},    {{9, -20, 874}, 1.1f},        {{18.5f, -108, 845.5f}, 1.1f},
       {{18, -93, 840.5f}, 1.2f}, {{18.4f, -76, 839.8f}, 1.3f}, {{18, -60, 840}, 1.3f},
       {{17.5f, -45, 845}, 1.2f}, {{11.5f, -32, 857}, 1.2f},    {{5, -22.5f, 867}, 1.1f}},
      7));
}

/// The muscle is the lowest sling: from the pubis around the anorectal junction, where it meets its
/// counterpart behind.
Shape puborectalis() {
  return shapeOf(Band{{{21, -111.5f, 844.5f}, 8, 1.2f, {0.66f, 0, 0.75f}},
                      {{24, -98, 845.5f}, 13.5f, 1.3f, {0.65f, 0, 0.76f}},
                      {{24.2f, -81, 841.5f}, 15, 1.4f, {0.62f, 0, 0.78f}},
                      {{23.4f, -63, 839.5f}, 13, 1.6f, {0.56f, 0, 0.83f}},
                      {{20.5f, -46, 837.5f}, 10.5f, 1.9f, {0.4f, 0, 0.9f}},
                      {{13.5f, -33, 837.5f}, 9.5f, 2.2f, {0.2f, -0.2f, 1}},
                      {{5, -28, 838}, 8.5f, 2, {0, -0.2f, 1}}});
}

/// The muscle runs from the front of the sacrum, beside its foramina, through the greater sciatic
/// foramen to the greater trochanter.
Shape piriformis() {
  Shape belly = shapeOf(Band{{{31, -29.6f, 928}, 9, 2.4f, {0.2f, -0.4f, 1}},
                             {{36, -29.2f, 924.5f}, 11.5f, 3, {0.3f, -0.2f, 1}},
                             {{43, -26.5f, 921}, 12.5f, 4.5f, {0.4f, 0, 1}},
                             {{52, -22.8f, 917}, 13, 6.3f, {0.45f, 0.1f, 1}},
                             {{75, -26, 905}, 10.5f, 7, {0.5f, 0.1f, 1}},
                             {{100, -43, 894}, 7.5f, 5.5f, {0.5f, 0, 1}},
                             {{122, -61.5f, 886.5f}, 4.6f, 3.8f, {0.4f, 0, 1}},
                             {{137, -71.5f, 881}, 3.2f, 2.8f, {0.3f, 0, 1}},
                             {{146, -78, 874}, 3, 3, {0.3f, 0, 1}}});
  return belly;
}

/// The muscle runs along the brim and over the hip joint to the lesser trochanter.
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
                             {{90, -117, 861}, 6.5f, 6.2f, {1, 0, 0}},
                             {{95, -104, 841}, 5.2f, 5.2f, {1, 0, 0}},
                             {{100, -90, 824}, 4.6f, 4.4f, {1, 0, 0}},
                             {{104, -78, 811}, 4.5f, 4, {1, 0, 0}}}),
                {42, -78, 1044}, {0, 0, 1}, 3.0f);
}

/// The muscle is the fan in the iliac fossa; beside the psoas it narrows over the hip joint
/// and goes to the lesser trochanter.
Shape iliacus() {
  return smoothed(
      Lamina({{{74, -62, 1022}, 3.2f},      {{96, -74, 1030}, 3.6f},     {{118, -89, 1030}, 3.6f},
              {{138, -111.5f, 1021}, 3.2f}, {{76, -66, 1012}, 3.8f},     {{98, -77, 1014}, 4.4f},
              {{119, -93, 1013}, 4.4f},     {{138, -121, 1006}, 3.2f},   {{70, -67, 1000}, 4.5f},
              {{92, -80, 1000}, 5.5f},      {{112, -94, 1000}, 5.5f},    {{131, -117, 996}, 4},
              {{68, -74, 980}, 4.5f},       {{88, -84, 980}, 7},         {{105, -97, 980}, 7},
              {{121, -119, 978}, 4.2f},     {{72, -84, 960}, 5},         {{86, -91, 960}, 7.5f},
              {{101, -105, 960}, 7.5f},     {{115, -122, 958}, 4},       {{79, -96, 938}, 5},
              {{88, -103, 938}, 7.5f},      {{97, -112, 938}, 7.5f},     {{107, -122, 938}, 4.5f},
              {{87, -113, 914}, 5},         {{92, -118, 914}, 7},        {{98, -122, 914}, 7},
              {{104, -127, 914}, 5},        {{91, -128, 890}, 4.5f},     {{94.5f, -129, 890}, 6},
              {{98, -130, 890}, 6},         {{101.5f, -131, 890}, 4.5f}, {{94, -122, 868}, 3.5f},
              {{97, -122, 868}, 4},         {{100, -122, 868}, 4},       {{103, -122, 868}, 3.5f},
              {{98, -113, 847}, 3},         {{101, -113, 847}, 3.4f},    {{104, -113, 847}, 3.4f},
              {{107, -113, 847}, 3},        {{102, -101, 828}, 2.6f},    {{104.5f, -101, 828}, 3},
              {{107, -101, 828}, 3},        {{109.5f, -101, 828}, 2.6f}, {{103, -88, 808}, 2.4f},
              {{105, -88, 808}, 2.6f},      {{107, -88, 808}, 2.6f},     {{109, -88, 808}, 2.4f}},
             4),
      3.0f);
}

/// The sphincter is an oval ring around the anal canal, drawn out to the coccyx behind.
Shape analSphincter() {
  const glm::vec3 centre(pelvisMiddle, -44, 823);
  const Field ring = [centre](const glm::vec3& p) {
    const glm::vec3 q = p - centre;
    // The ring is an egg with its point to the back: narrower there, wider in front.
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
  Palette thin = musclePalette;
  thin.edge = 1.5f;
  addPair(list, thin, "puborectalis", puborectalis());
  addPair(list, thin, "pubococcygeus", pubococcygeus());
  addPair(list, thin, "iliococcygeus", iliococcygeus());
  addPair(list, thin, "coccygeus", coccygeus());
  Palette grooved = musclePalette;  // by the pudendal vessels
  grooved.edge = 1.9f;
  addPair(list, grooved, "obturator internus", obturatorInternus());
  addPair(list, musclePalette, "piriformis", piriformis());
  addPair(list, musclePalette, "psoas major", psoasMajor());
  addPair(list, musclePalette, "iliacus", iliacus());
  // Where neighbours graze a muscle its border stays even.
  for (DemoStructure& s : list)
    s.smoothing = s.edge < musclePalette.edge ? 0.8f : 1.3f;
  for (DemoStructure& s : list)
    if (s.name.ends_with("iliacus")) {
      s.rounding = 3.0f;  // a soft furrow beside the psoas
      s.edge = 2.0f;
    }

  list.push_back(structure(musclePalette, "external anal sphincter", analSphincter()));
  return list;
}

}  // namespace sline::model
