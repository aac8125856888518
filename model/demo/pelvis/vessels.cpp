// SPDX-License-Identifier: Apache-2.0
// Models the vessels. The aorta divides left of the midline and the caval confluence lies right of
// it, so left and right iliac vessels are no mirror images; their branches in the lesser pelvis
// are.
#include <algorithm>
#include <array>

#include "model/demo/pelvis/parts.h"
#include "model/sculpting/pipe.h"

namespace sline::model {

namespace {
DemoStructure artery(const char* name, Shape shape) {
  return structure(arteryPalette, name, std::move(shape));
}
DemoStructure vein(const char* name, Shape shape) {
  return structure(veinPalette, name, std::move(shape));
}

PipeEnd opposite(const PipeEnd& end) {
  return {end.point, -end.normal};
}

/// Returns the part of the box on the near side of a plane that faces mostly along z.
Box upTo(const PipeEnd& end, Box box) {
  constexpr float slant = 8.0f;  // mm that the plane rises and falls within a vessel
  float& face = end.normal.z > 0.0f ? box.high.z : box.low.z;
  face = end.normal.z > 0.0f ? std::min(face, end.point.z + slant)
                             : std::max(face, end.point.z - slant);
  return box;
}

float wallOf(const Palette& palette) {
  return &palette == &arteryPalette ? 1.8f : 1.6f;
}

/// Cuts a hollow piece out of a vessel's course. The lumen is that of the whole course, so that it
/// continues from vessel to vessel and shows where one is cut.
DemoStructure pieceOf(const Shape& course, const Palette& palette, const char* name,
                      std::initializer_list<PipeEnd> ends) {
  Shape piece = course;
  for (const PipeEnd& end : ends) {
    piece = cutOff(std::move(piece), end.point, end.normal);
    piece.box = upTo(end, piece.box);
  }
  return withCavity(structure(palette, name, std::move(piece)),
                    [course = course.field, wall = wallOf(palette)](const glm::vec3& p) {
                      return course(p) + wall;
                    });
}

/// Gives the vessel a finer mesh, for clean rims where it is cut.
DemoStructure fine(DemoStructure vessel) {
  vessel.edge = 1.05f;
  vessel.rounding = 1.0f;
  return vessel;
}

/// Cuts out a piece without branches.
DemoStructure pieceOf(const Tube& course, const Palette& palette, const char* name,
                      const std::array<PipeEnd, 2>& ends) {
  DemoStructure piece = pieceOf(shapeOf(course), palette, name, {ends[0], ends[1]});
  // Even triangles may be larger.
  piece.pattern = pipe(course.course(), wallOf(palette), ends, 1.35f * palette.edge);
  return piece;
}

/// The course runs from within the aorta to below the inguinal ligament.
const std::initializer_list<TubePoint> leftArteryCourse{
    {{5.2f, -138, 1057}, 4.2f},   {{6, -137.5f, 1045}, 5.2f},   {{9, -134.5f, 1033}, 5.6f},
    {{13, -130, 1023}, 5.5f},     {{17.5f, -125, 1013}, 5.5f},  {{22.5f, -119, 1003}, 5.5f},
    {{28, -112.5f, 993}, 5.4f},   {{33, -107, 983}, 5.4f},      {{38, -102, 974}, 5.3f},
    {{43.3f, -97.5f, 964}, 5.2f}, {{48.8f, -94.2f, 954}, 5.1f}, {{54, -93, 944}, 5},
    {{58.7f, -94.5f, 934}, 5},    {{62, -99, 924}, 5},          {{63.2f, -108, 914}, 5},
    {{61, -125, 904}, 4.9f},      {{56, -145, 895}, 4.9f},      {{52.8f, -162, 885}, 4.8f},
    {{52, -171, 876}, 4.8f}};
const std::initializer_list<TubePoint> rightArteryCourse{
    {{4.2f, -138, 1057}, 4.2f},     {{2.6f, -137.5f, 1045}, 5.2f},  {{-1.5f, -137.3f, 1034}, 5.6f},
    {{-6.5f, -136, 1024.5f}, 5.5f}, {{-13, -133.5f, 1015}, 5.5f},   {{-20.5f, -130.3f, 1005}, 5.5f},
    {{-28, -126.3f, 995}, 5.4f},    {{-35, -121, 985.5f}, 5.3f},    {{-41.5f, -114, 977}, 5.2f},
    {{-48.5f, -105.5f, 967}, 5.2f}, {{-55, -97.8f, 957}, 5.1f},     {{-59.5f, -93.2f, 947}, 5},
    {{-62, -92.2f, 937}, 5},        {{-63.2f, -95, 927}, 5},        {{-63.2f, -101.8f, 917}, 5},
    {{-62, -112, 907}, 4.9f},       {{-60.5f, -124.5f, 897}, 4.9f}, {{-58.5f, -138, 887}, 4.8f},
    {{-56, -151, 877}, 4.8f},       {{-53.5f, -162, 868}, 4.8f}};
const PipeEnd leftBifurcation{{9, -134.5f, 1033}, {0.34f, 0.36f, -0.87f}};
const PipeEnd rightBifurcation{{-1.6f, -137.3f, 1033.7f}, {-0.48f, 0.1f, -0.87f}};
const PipeEnd leftArteryFork{{35.8f, -104.1f, 978}, {0.44f, 0.44f, -0.78f}};
const PipeEnd rightArteryFork{{-37.8f, -118, 981.8f}, {-0.52f, 0.5f, -0.7f}};

void addMainArteries(std::vector<DemoStructure>& list) {
  const Tube left(leftArteryCourse);
  const Tube right(rightArteryCourse);
  const Shape aorta = branching({Tube{{{7, -138, 1086}, 7.6f},
                                      {{6.5f, -138, 1069}, 7.5f},
                                      {{5.2f, -138, 1055}, 7.4f},
                                      {{4.2f, -137.5f, 1045}, 6.4f}},
                                 Tube(leftArteryCourse), Tube(rightArteryCourse)},
                                5.0f);
  list.push_back(fine(pieceOf(aorta, arteryPalette, "abdominal aorta",
                              {{{7, -138, 1076}, {0, 0, 1}}, leftBifurcation, rightBifurcation})));
  list.push_back(pieceOf(left, arteryPalette, "left common iliac artery",
                         {{opposite(leftBifurcation), leftArteryFork}}));
  list.push_back(pieceOf(right, arteryPalette, "right common iliac artery",
                         {{opposite(rightBifurcation), rightArteryFork}}));
  list.push_back(
      pieceOf(left, arteryPalette, "left external iliac artery",
              {{opposite(leftArteryFork), {{52.8f, -163, 884}, {-0.05f, -0.7f, -0.7f}}}}));
  list.push_back(
      pieceOf(right, arteryPalette, "right external iliac artery",
              {{opposite(rightArteryFork), {{-55.5f, -153.5f, 875}, {0.12f, -0.75f, -0.65f}}}}));
}

/// Models the internal iliac artery, whose continuation to the greater sciatic foramen is the
/// superior gluteal artery.
Shape leftInternalArtery() {
  return shapeOf(Tube{{{34.5f, -106, 984}, 4},
                      {{31, -104.5f, 974}, 3.1f},
                      {{27.5f, -99.5f, 963}, 2.7f},
                      {{26.5f, -86, 952}, 2.6f},
                      {{28.5f, -66, 943.5f}, 2.4f},
                      {{31, -42, 933}, 2.1f},
                      {{32, -31, 924}, 1.8f},
                      {{32, -26, 914.5f}, 1.5f}});
}

Shape rightInternalArtery() {
  return shapeOf(Tube{{{-36.5f, -119.5f, 987}, 3.8f},
                      {{-34, -115.5f, 976.5f}, 2.9f},
                      {{-33, -109.5f, 967}, 2.5f},
                      {{-34, -96.5f, 957}, 2.4f},
                      {{-36.5f, -77, 947.5f}, 2.2f},
                      {{-37.5f, -53, 938}, 2},
                      {{-37.8f, -42, 930}, 1.8f},
                      {{-37.5f, -35.5f, 924}, 1.5f}});
}

void addArteryBranches(std::vector<DemoStructure>& list) {
  Palette thin = arteryPalette;
  thin.edge = 1.0f;
  addPair(list, thin, "obturator artery",
          shapeOf(Tube{{{29, -76, 947}, 1.5f},
                       {{41, -71.5f, 930}, 1.5f},
                       {{52, -83, 911}, 1.4f},
                       {{52, -98, 897}, 1.4f},
                       {{47.5f, -112, 884}, 1.3f},
                       {{43, -118, 875}, 1.2f}}));
  // This is the part of the umbilical artery that stays open, and its branches to the bladder's
  // top.
  addPair(list, thin, "superior vesical artery",
          branching({Tube{{{27.5f, -77, 948}, 1.6f},
                          {{38.5f, -70.5f, 939}, 1.5f},
                          {{43.1f, -76, 931}, 1.5f},
                          {{42.5f, -86, 921}, 1.4f},
                          {{42.8f, -92.5f, 911}, 1.3f},
                          {{40, -99, 904}, 1.2f},
                          {{33, -107, 897}, 1.1f},
                          {{25, -113, 893}, 1},
                          {{17, -120, 892}, 0.8f}},
                     Tube{{{42.6f, -90, 915}, 1.2f},
                          {{42, -92.5f, 905}, 1.1f},
                          {{39, -93, 895}, 1},
                          {{34.5f, -92, 887}, 0.8f}}},
                    1.5f));
  addPair(list, thin, "internal pudendal artery",
          shapeOf(Tube{{{33, -58, 942}, 1.7f},
                       {{37, -46, 924}, 1.6f},
                       {{42, -31, 907}, 1.5f},
                       {{51, -29, 893}, 1.4f},
                       {{52.5f, -36, 879}, 1.4f},
                       {{46.5f, -51, 862}, 1.3f},
                       {{39, -68, 847}, 1.2f},
                       {{30, -88, 836}, 1.1f}}));
}
}  // namespace

std::vector<DemoStructure> pelvisArteries() {
  std::vector<DemoStructure> list;
  addMainArteries(list);
  list.push_back(artery("left internal iliac artery", leftInternalArtery()));
  list.push_back(artery("right internal iliac artery", rightInternalArtery()));
  addArteryBranches(list);
  return list;
}

namespace {
/// The course runs from within the vena cava to below the inguinal ligament.
const std::initializer_list<TubePoint> leftVeinCourse{
    {{-11.3f, -132.5f, 1061}, 4.6f}, {{-9, -130.5f, 1049}, 6},      {{-4.3f, -127.5f, 1038}, 7.1f},
    {{1.2f, -123.5f, 1027}, 7.1f},   {{5.4f, -120, 1016}, 7.2f},    {{9.4f, -116.2f, 1005}, 7.2f},
    {{14, -108, 993.5f}, 7.1f},      {{19.3f, -99.5f, 982}, 6.9f},  {{25, -93.3f, 973}, 6.6f},
    {{31, -87.6f, 964}, 6.3f},       {{37, -84.5f, 955}, 6},        {{42.3f, -83.2f, 946.5f}, 5.8f},
    {{47, -83.8f, 938}, 5.7f},       {{51, -86.5f, 928}, 5.6f},     {{53.4f, -92.5f, 918}, 5.5f},
    {{53.4f, -104.5f, 908}, 5.5f},   {{49.8f, -125, 898.5f}, 5.5f}, {{44.5f, -145, 888}, 5.4f},
    {{41, -158.5f, 877}, 5.3f},      {{39, -167, 868.5f}, 5.3f}};
const std::initializer_list<TubePoint> rightVeinCourse{
    {{-12, -132.5f, 1061}, 4.6f},     {{-13.5f, -130.5f, 1049}, 6},
    {{-16.6f, -127.5f, 1038}, 7},     {{-18.5f, -123.7f, 1027}, 7},
    {{-21.5f, -120, 1016}, 7.1f},     {{-24.7f, -116, 1004.5f}, 7.2f},
    {{-28.3f, -111.7f, 993}, 7.3f},   {{-32.3f, -106.5f, 982}, 7.1f},
    {{-36.5f, -99.5f, 972.5f}, 6.7f}, {{-41, -91, 963}, 6.3f},
    {{-45.5f, -83.7f, 954}, 6},       {{-48.7f, -79.5f, 945.5f}, 5.8f},
    {{-50.4f, -79, 936.5f}, 5.7f},    {{-51.3f, -82.5f, 927}, 5.6f},
    {{-51.5f, -89.5f, 917}, 5.5f},    {{-51, -100.5f, 907.5f}, 5.5f},
    {{-49.5f, -115, 898}, 5.5f},      {{-47, -129, 888}, 5.4f},
    {{-44.5f, -143, 878}, 5.4f},      {{-43, -156, 868}, 5.3f},
    {{-42, -167, 858}, 5.3f}};
const PipeEnd leftConfluence{{-2.6f, -126.2f, 1034.7f}, {0.45f, 0.35f, -0.82f}};
const PipeEnd rightConfluence{{-17.2f, -126.6f, 1034.7f}, {-0.22f, 0.32f, -0.92f}};
const PipeEnd leftVeinFork{{23, -95.3f, 976.3f}, {0.5f, 0.42f, -0.76f}};
const PipeEnd rightVeinFork{{-33.6f, -104.5f, 979}, {-0.36f, 0.5f, -0.79f}};

void addMainVeins(std::vector<DemoStructure>& list) {
  const Tube left(leftVeinCourse);
  const Tube right(rightVeinCourse);
  const Shape cava = branching({Tube{{{-12, -133, 1084}, 8.3f},
                                     {{-11.8f, -133, 1070}, 8.2f},
                                     {{-11.5f, -132.3f, 1058}, 8},
                                     {{-11.2f, -131, 1049}, 6.8f}},
                                Tube(leftVeinCourse), Tube(rightVeinCourse)},
                               6.0f);
  list.push_back(fine(pieceOf(cava, veinPalette, "inferior vena cava",
                              {{{-12, -133, 1073}, {0, 0, 1}}, leftConfluence, rightConfluence})));
  list.push_back(pieceOf(left, veinPalette, "left common iliac vein",
                         {{opposite(leftConfluence), leftVeinFork}}));
  list.push_back(pieceOf(right, veinPalette, "right common iliac vein",
                         {{opposite(rightConfluence), rightVeinFork}}));
  list.push_back(
      pieceOf(left, veinPalette, "left external iliac vein",
              {{opposite(leftVeinFork), {{41, -158.5f, 876.5f}, {-0.15f, -0.72f, -0.68f}}}}));
  list.push_back(
      pieceOf(right, veinPalette, "right external iliac vein",
              {{opposite(rightVeinFork), {{-43, -158, 866.5f}, {0.1f, -0.75f, -0.65f}}}}));
}
}  // namespace

std::vector<DemoStructure> pelvisVeins() {
  std::vector<DemoStructure> list;
  addMainVeins(list);
  list.push_back(vein("left internal iliac vein", shapeOf(Tube{{{20.8f, -94, 978}, 4.6f},
                                                               {{25, -88, 970}, 4.6f},
                                                               {{27, -78, 961}, 4.3f},
                                                               {{26, -63, 954}, 3.7f},
                                                               {{26, -51, 948}, 2.8f}})));
  list.push_back(vein("right internal iliac vein", shapeOf(Tube{{{-33.2f, -106, 978}, 4.6f},
                                                                {{-31, -96, 969.5f}, 4.6f},
                                                                {{-28.5f, -80, 960}, 4.3f},
                                                                {{-27, -65, 953.5f}, 3.7f},
                                                                {{-27.5f, -53, 947.5f}, 2.8f}})));
  return list;
}

}  // namespace sline::model
