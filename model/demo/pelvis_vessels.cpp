// SPDX-License-Identifier: Apache-2.0
// The aorta parts left of the midline and the caval confluence lies right of it, so left and right
// iliac vessels are no mirror images; their branches in the lesser pelvis are.
#include "model/demo/pelvis_parts.h"

namespace sline::model {

namespace {
DemoStructure artery(const char* name, Shape shape) {
  return structure(arteryPalette, name, std::move(shape));
}
DemoStructure vein(const char* name, Shape shape) {
  return structure(veinPalette, name, std::move(shape));
}

/// The end of the aorta with the stumps of both common iliac arteries.
Shape aorta() {
  Shape trunk = branching(
      {Tube{{{7, -138, 1084}, 7.6f},
            {{6.5f, -138, 1064}, 7.5f},
            {{5, -137.5f, 1049}, 7.4f},
            {{4, -137, 1042}, 6.6f}},
       Tube{{{5, -137.5f, 1050}, 5.5f}, {{6.5f, -137, 1041}, 5.7f}, {{10, -134, 1030}, 5.5f}},
       Tube{
           {{4, -137.5f, 1050}, 5.5f}, {{1.5f, -137.5f, 1041}, 5.7f}, {{-4, -136.5f, 1030}, 5.5f}}},
      3.0f);
  trunk = cutOff(std::move(trunk), {7, -138, 1076}, {0, 0, 1});
  trunk = cutOff(std::move(trunk), {7.8f, -136, 1037}, {0.28f, 0.25f, -0.93f});
  return cutOff(std::move(trunk), {-1, -137, 1037}, {-0.4f, 0.1f, -0.9f});
}

Shape leftCommonArtery() {
  return cutOff(shapeOf(Tube{{{5.5f, -137.5f, 1045}, 5.6f},
                             {{9, -134.5f, 1033}, 5.6f},
                             {{13, -130, 1023}, 5.5f},
                             {{17.5f, -125, 1013}, 5.5f},
                             {{22.5f, -119, 1003}, 5.5f},
                             {{28, -112.5f, 993}, 5.5f},
                             {{33, -107, 983}, 5.5f},
                             {{36, -104, 977}, 5.4f}}),
                {33.5f, -106.5f, 982}, {0.42f, 0.42f, -0.8f});
}

Shape rightCommonArtery() {
  return cutOff(shapeOf(Tube{{{3.5f, -137.5f, 1045}, 5.6f},
                             {{1, -137.3f, 1037}, 5.6f},
                             {{-5, -136.5f, 1026}, 5.5f},
                             {{-12.5f, -133.5f, 1015}, 5.5f},
                             {{-20.5f, -130.5f, 1005}, 5.5f},
                             {{-28, -126.5f, 995}, 5.4f},
                             {{-35, -121.5f, 985}, 5.3f},
                             {{-39, -118, 979}, 5.2f}}),
                {-35.7f, -121, 984}, {-0.5f, 0.4f, -0.75f});
}

Shape leftExternalArtery() {
  return cutOff(shapeOf(Tube{{{31, -109, 987}, 5.2f},
                             {{33.5f, -106.5f, 982}, 5.3f},
                             {{38, -102, 974}, 5.2f},
                             {{43, -97.5f, 964}, 5.1f},
                             {{49, -94, 954}, 5},
                             {{54, -93, 944}, 5},
                             {{58.5f, -94.5f, 934}, 5},
                             {{62, -99, 924}, 5},
                             {{64, -107, 914}, 5},
                             {{62, -124, 904}, 4.9f},
                             {{55, -145, 895}, 4.9f},
                             {{52.5f, -162, 885}, 4.8f},
                             {{52, -169, 878}, 4.8f}}),
                {52.5f, -163, 884}, {0, -0.65f, -0.75f});
}

Shape rightExternalArtery() {
  return cutOff(shapeOf(Tube{{{-33, -123.5f, 989}, 5},
                             {{-36, -121, 984}, 5.2f},
                             {{-42, -113.5f, 977}, 5.2f},
                             {{-49, -105, 967}, 5.1f},
                             {{-55, -97.5f, 957}, 5},
                             {{-59.5f, -93, 947}, 5},
                             {{-62, -92, 937}, 5},
                             {{-63, -95, 927}, 5},
                             {{-63, -101.5f, 917}, 5},
                             {{-62, -112, 907}, 4.9f},
                             {{-60.5f, -124.5f, 897}, 4.9f},
                             {{-58.5f, -138, 887}, 4.8f},
                             {{-56, -151, 877}, 4.8f},
                             {{-54.5f, -158, 871}, 4.8f}}),
                {-55.5f, -153.5f, 875}, {0.1f, -0.7f, -0.7f});
}

/// Its continuation to the greater sciatic foramen is the superior gluteal artery.
Shape leftInternalArtery() {
  return shapeOf(Tube{{{33.5f, -108, 984}, 2.6f},
                      {{30.5f, -106, 974}, 2.7f},
                      {{27.5f, -99.5f, 963}, 2.7f},
                      {{26.5f, -86, 952}, 2.6f},
                      {{28.5f, -66, 943.5f}, 2.4f},
                      {{31, -42, 933}, 2.1f},
                      {{32, -31, 924}, 1.8f},
                      {{32, -26, 914.5f}, 1.5f}});
}

Shape rightInternalArtery() {
  return shapeOf(Tube{{{-35.5f, -121.5f, 986}, 2.4f},
                      {{-33.8f, -117, 976}, 2.5f},
                      {{-33, -109.5f, 967}, 2.5f},
                      {{-34, -96.5f, 957}, 2.4f},
                      {{-36.5f, -77, 947.5f}, 2.2f},
                      {{-37.5f, -53, 938}, 2},
                      {{-37.8f, -42, 930}, 1.8f},
                      {{-37.5f, -35.5f, 924}, 1.5f}});
}

void addArteryBranches(std::vector<DemoStructure>& list) {
  addPair(list, arteryPalette, "obturator artery",
          shapeOf(Tube{{{29, -76, 947}, 1.5f},
                       {{41, -75, 931}, 1.5f},
                       {{52, -83, 911}, 1.4f},
                       {{52, -98, 897}, 1.4f},
                       {{47.5f, -112, 884}, 1.3f},
                       {{43, -118, 875}, 1.2f}}));
  // The part of the umbilical artery that stays open, and its branches to the bladder's top.
  addPair(list, arteryPalette, "superior vesical artery",
          branching({Tube{{{27.5f, -77, 948}, 1.6f},
                          {{36, -75, 939}, 1.5f},
                          {{42, -81, 930}, 1.5f},
                          {{44, -90, 916}, 1.4f},
                          {{40, -99, 904}, 1.2f},
                          {{33, -107, 897}, 1.1f},
                          {{25, -113, 893}, 1},
                          {{17, -120, 892}, 0.8f}},
                     Tube{{{44, -88, 919}, 1.3f},
                          {{43, -92, 906}, 1.1f},
                          {{39, -93, 895}, 1},
                          {{34.5f, -92, 887}, 0.8f}}},
                    1.5f));
  addPair(list, arteryPalette, "internal pudendal artery",
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
  list.push_back(artery("abdominal aorta", aorta()));
  list.push_back(artery("left common iliac artery", leftCommonArtery()));
  list.push_back(artery("right common iliac artery", rightCommonArtery()));
  list.push_back(artery("left external iliac artery", leftExternalArtery()));
  list.push_back(artery("right external iliac artery", rightExternalArtery()));
  list.push_back(artery("left internal iliac artery", leftInternalArtery()));
  list.push_back(artery("right internal iliac artery", rightInternalArtery()));
  addArteryBranches(list);
  return list;
}

namespace {
Shape cava() {
  Shape trunk = branching(
      {Tube{{{-12, -133, 1084}, 8.3f}, {{-11.5f, -133, 1064}, 8.2f}, {{-11, -131, 1048}, 8}},
       Tube{{{-11, -132, 1058}, 7}, {{-9.3f, -128.5f, 1040}, 7}, {{-6, -123.5f, 1027}, 7}},
       Tube{{{-11.5f, -132, 1058}, 7}, {{-12.8f, -128, 1040}, 7}, {{-17.5f, -123, 1027}, 7}}},
      3.0f);
  trunk = cutOff(std::move(trunk), {-12, -133, 1073}, {0, 0, 1});
  trunk = cutOff(std::move(trunk), {-8.8f, -127.7f, 1038}, {0.35f, 0.4f, -0.85f});
  return cutOff(std::move(trunk), {-13.3f, -127.5f, 1038}, {-0.3f, 0.4f, -0.85f});
}

Shape leftCommonVein() {
  return cutOff(shapeOf(Tube{{{-10, -129.5f, 1044}, 7},
                             {{-7.5f, -126, 1033}, 7.2f},
                             {{-3.5f, -121, 1022}, 7},
                             {{1.5f, -115, 1012}, 7.2f},
                             {{7, -109, 1002}, 7.3f},
                             {{13, -102.5f, 992}, 7.2f},
                             {{19, -96.5f, 982}, 7.2f},
                             {{24, -92, 973}, 7}}),
                {20.8f, -94.7f, 979}, {0.5f, 0.45f, -0.75f});
}

Shape rightCommonVein() {
  return cutOff(shapeOf(Tube{{{-12, -129.5f, 1044}, 7},
                             {{-14.5f, -126, 1033}, 7},
                             {{-17, -123.5f, 1022}, 7},
                             {{-20.5f, -120.5f, 1012}, 7},
                             {{-24, -116.5f, 1002}, 7},
                             {{-28, -112.5f, 992}, 7.3f},
                             {{-32, -108, 982}, 7.7f},
                             {{-36, -103, 973}, 7.6f}}),
                {-33.3f, -106.5f, 979}, {-0.4f, 0.45f, -0.8f});
}

Shape leftExternalVein() {
  return cutOff(shapeOf(Tube{{{18.5f, -97, 983}, 6},
                             {{20.5f, -95, 979.5f}, 6.3f},
                             {{29, -89, 967}, 6.3f},
                             {{36, -84.8f, 957}, 6},
                             {{42, -82.8f, 948}, 5.8f},
                             {{47, -83.5f, 938}, 5.7f},
                             {{51, -86, 928}, 5.6f},
                             {{54, -91, 918}, 5.5f},
                             {{54.5f, -104, 908}, 5.5f},
                             {{50, -125, 899}, 5.5f},
                             {{44, -145, 888}, 5.4f},
                             {{41, -158, 877}, 5.3f},
                             {{40, -164, 871}, 5.3f}}),
                {41, -158.5f, 876.5f}, {-0.1f, -0.7f, -0.7f});
}

Shape rightExternalVein() {
  return cutOff(shapeOf(Tube{{{-31.5f, -109, 984}, 6},
                             {{-33.3f, -106.5f, 979}, 6.2f},
                             {{-38.5f, -96, 968}, 6.2f},
                             {{-43.5f, -86, 958}, 6},
                             {{-48, -79, 948}, 5.8f},
                             {{-50, -78, 938}, 5.7f},
                             {{-51, -81.5f, 928}, 5.6f},
                             {{-51.5f, -88, 918}, 5.5f},
                             {{-51, -100, 908}, 5.5f},
                             {{-49.5f, -115, 898}, 5.5f},
                             {{-47, -129, 888}, 5.4f},
                             {{-44.5f, -143, 878}, 5.4f},
                             {{-43, -156, 868}, 5.3f},
                             {{-42.5f, -162, 863}, 5.3f}}),
                {-43, -158, 867}, {0, -0.75f, -0.65f});
}
}  // namespace

std::vector<DemoStructure> pelvisVeins() {
  std::vector<DemoStructure> list;
  list.push_back(vein("inferior vena cava", cava()));
  list.push_back(vein("left common iliac vein", leftCommonVein()));
  list.push_back(vein("right common iliac vein", rightCommonVein()));
  list.push_back(vein("left external iliac vein", leftExternalVein()));
  list.push_back(vein("right external iliac vein", rightExternalVein()));
  list.push_back(vein("left internal iliac vein", branching({Tube{{{21.5f, -96, 981}, 4.2f},
                                                                  {{20.5f, -90, 972}, 4.4f},
                                                                  {{21, -75, 962}, 4.2f},
                                                                  {{23.5f, -57, 952}, 3.8f},
                                                                  {{27, -38, 940}, 3.2f},
                                                                  {{29.5f, -25, 928}, 2.6f}},
                                                             Tube{{{22, -66, 956}, 2.6f},
                                                                  {{35.5f, -60, 938}, 2.5f},
                                                                  {{47, -67, 920}, 2.3f},
                                                                  {{51, -79, 903}, 2}}},
                                                            3.0f)));
  list.push_back(vein("right internal iliac vein", branching({Tube{{{-33.5f, -107, 981}, 4.2f},
                                                                   {{-31, -99, 971}, 4.4f},
                                                                   {{-28.5f, -82, 961}, 4.2f},
                                                                   {{-28, -61, 951}, 3.8f},
                                                                   {{-30, -41, 939}, 3.2f},
                                                                   {{-32, -28, 928}, 2.6f}},
                                                              Tube{{{-28, -70, 955}, 2.6f},
                                                                   {{-37, -62, 938}, 2.5f},
                                                                   {{-48, -68, 920}, 2.3f},
                                                                   {{-52, -80, 903}, 2}}},
                                                             3.0f)));
  return list;
}

}  // namespace sline::model
