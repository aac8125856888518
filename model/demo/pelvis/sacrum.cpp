// SPDX-License-Identifier: Apache-2.0
// Models the sacrum by hand from the measures of one body (BodyParts3D) and from anatomy textbooks.
#include "model/demo/pelvis/sacrum.h"

#include "model/demo/pelvis/bones.h"
#include "model/demo/pelvis/lumbar_vertebra.h"

namespace sline::model {

namespace {
constexpr float x = pelvisMiddle;

/// Adds the fused bodies and their connection to the lateral parts; rows from S1 down to S5.
void addBodies(Sculpture& bone) {
  bone.addPlate(
      {{{{x - 34, -58, 975}, 10.0f}, {{x - 18, -66, 976}, 11.0f}, {{x, -69, 977}, 12.0f},
        {{x + 18, -66, 976}, 11.0f}, {{x + 34, -58, 975}, 10.0f}, {{x - 38, -50, 964}, 10.0f},
        {{x - 20, -53, 966}, 11.0f}, {{x, -55, 967}, 12.0f},      {{x + 20, -53, 966}, 11.0f},
        {{x + 38, -50, 964}, 10.0f}, {{x - 40, -37, 950}, 9.0f},  {{x - 20, -36, 952}, 8.5f},
        {{x, -37, 952}, 9.5f},       {{x + 20, -36, 952}, 8.5f},  {{x + 40, -37, 950}, 9.0f},
        {{x - 39, -23, 936}, 7.0f},  {{x - 18, -18, 937}, 7.0f},  {{x, -19, 937}, 8.0f},
        {{x + 18, -18, 937}, 7.0f},  {{x + 39, -23, 936}, 7.0f},  {{x - 35, -18, 920}, 5.0f},
        {{x - 16, -11, 920}, 5.5f},  {{x, -11, 920}, 6.5f},       {{x + 16, -11, 920}, 5.5f},
        {{x + 35, -18, 920}, 5.0f},  {{x - 26, -19, 906}, 4.5f},  {{x - 13, -12, 905}, 5.0f},
        {{x, -10, 905}, 5.5f},       {{x + 13, -12, 905}, 5.0f},  {{x + 26, -19, 906}, 4.5f},
        {{x - 9, -12, 893}, 3.6f},   {{x - 5, -11, 892}, 4.2f},   {{x, -10, 892}, 4.8f},
        {{x + 5, -11, 892}, 4.2f},   {{x + 9, -12, 893}, 3.6f}},
       5},
      1.0f);
  // This is the end plate of S1, whose front edge is the promontory.
  const VertebralBody top{.centre = {x, -70.8f, 974.0f},
                          .tilt = 26.6f,
                          .halfWidth = 25.5f,
                          .halfDepth = 19.3f,
                          .halfHeight = 7.0f,
                          .wedge = 0.0f,
                          .waist = 0.0f,
                          .hollow = 0.9f};
  bone.add([top](const glm::vec3& p) { return top.distance(p); }, top.bounds(), 9.0f);
  bone.addPlate({{{{x - 15, -75, 967}, 6.0f},
                  {{x, -78, 967}, 7.0f},
                  {{x + 15, -75, 967}, 6.0f},
                  {{x - 17, -60, 957}, 7.5f},
                  {{x, -61, 956}, 8.5f},
                  {{x + 17, -60, 957}, 7.5f}},
                 3},
                9.0f);
  // The bodies have grown together here.
  bone.addTube({{{x - 17, -40.5f, 946.5f}, 1.0f},
                {{x, -41, 946.5f}, 2.0f},
                {{x + 17, -40.5f, 946.5f}, 1.0f}},
               5.0f);
  bone.addTube(
      {{{x - 16, -22, 930.5f}, 1.0f}, {{x, -22.5f, 930.5f}, 2.0f}, {{x + 16, -22, 930.5f}, 1.0f}},
      5.0f);
  bone.addTube({{{x - 14, -15, 913}, 1.2f}, {{x, -15.5f, 913}, 2.0f}, {{x + 14, -15, 913}, 1.2f}},
               5.0f);
}

/// Adds the wings, and behind them the face for the hip bone.
void addLateralParts(Sculpture& bone) {
  bone.addPlatePair({{{{x + 28, -58, 984}, 6.0f},
                      {{x + 41, -54, 987}, 7.0f},
                      {{x + 52, -50, 994}, 6.0f},
                      {{x + 28, -60, 972}, 8.0f},
                      {{x + 43, -57, 974}, 9.0f},
                      {{x + 59, -58, 977}, 7.5f},
                      {{x + 28, -54, 960}, 8.0f},
                      {{x + 42, -57, 961}, 8.0f},
                      {{x + 61, -66, 962}, 6.5f},
                      {{x + 28, -46, 951}, 7.0f},
                      {{x + 42, -55, 951}, 7.0f},
                      {{x + 61, -70, 953}, 5.5f},
                      {{x + 30, -34, 944}, 6.0f},
                      {{x + 42, -48, 945}, 5.0f},
                      {{x + 57, -64, 945}, 5.0f}},
                     3},
                    6.0f);
  bone.addPlatePair({{{{x + 54, -52, 970}, 9.0f},
                      {{x + 44, -34, 970}, 8.0f},
                      {{x + 52, -46, 953}, 9.0f},
                      {{x + 44, -26, 953}, 8.0f},
                      {{x + 50, -42, 944}, 6.0f},
                      {{x + 41, -22, 936}, 6.0f}},
                     2},
                    6.0f);
  bone.addTubePair({{{x + 43, -26, 938}, 6.5f},
                    {{x + 37, -19, 922}, 6.0f},
                    {{x + 30, -18, 909}, 5.0f},
                    {{x + 19, -15, 899.5f}, 4.3f},
                    {{x + 6, -11, 892}, 3.9f}},
                   6.0f);
  // The superior articular processes are hollow towards the back and the middle.
  bone.addPlatePair({{{{x + 19, -57, 1001}, 1.9f},
                      {{x + 25, -57, 1003}, 2.3f},
                      {{x + 29, -50, 1001}, 1.9f},
                      {{x + 20, -57, 992}, 2.6f},
                      {{x + 26, -56, 992}, 3.2f},
                      {{x + 30, -48, 992}, 2.8f},
                      {{x + 20, -53, 982}, 4.0f},
                      {{x + 26, -51, 982}, 5.0f},
                      {{x + 30, -44, 982}, 5.0f}},
                     3},
                    5.0f);
}

/// Adds the roof of the canal with its crests.
void addBack(Sculpture& bone) {
  bone.addPlate({{{{x - 17, -43, 978}, 3.0f},
                  {{x, -31, 981}, 4.0f},
                  {{x + 17, -43, 978}, 3.0f},
                  {{x - 18, -34, 965}, 4.0f},
                  {{x, -23, 966}, 4.0f},
                  {{x + 18, -34, 965}, 4.0f},
                  {{x - 15, -22, 949}, 4.0f},
                  {{x, -13, 950}, 4.0f},
                  {{x + 15, -22, 949}, 4.0f},
                  {{x - 13, -12, 933}, 3.6f},
                  {{x, -5, 933}, 4.0f},
                  {{x + 13, -12, 933}, 3.6f},
                  {{x - 10, -6, 917}, 3.2f},
                  {{x, -1, 917}, 3.5f},
                  {{x + 10, -6, 917}, 3.2f},
                  {{x - 7, -4, 906}, 2.5f},
                  {{x, -2, 906}, 2.8f},
                  {{x + 7, -4, 906}, 2.5f}},
                 3},
                9.0f);
  bone.addTube({{{x, -28, 983}, 2.5f},
                {{x, -25, 979}, 3.6f},
                {{x, -19, 968}, 2.8f},
                {{x, -13, 959}, 3.6f},
                {{x, -9, 949}, 2.8f},
                {{x, -3, 940}, 3.6f},
                {{x, -1, 931}, 2.8f},
                {{x, 2, 922}, 3.4f},
                {{x, 1, 912}, 2.5f}},
               4.0f);
  bone.addTubePair({{{x + 36, -31, 966}, 5.0f},
                    {{x + 39, -20, 952}, 6.0f},
                    {{x + 38, -15, 937}, 5.0f},
                    {{x + 34, -14, 920}, 4.0f},
                    {{x + 26, -14, 906}, 4.0f}},
                   10.0f);
  // These are the horns beside the hiatus.
  bone.addTubePair(
      {{{x + 9, -3, 912}, 3.0f}, {{x + 9.5f, -1, 903}, 2.8f}, {{x + 10, -2, 896}, 2.0f}}, 3.0f);
}

void carveForamina(Sculpture& bone) {
  bone.carveTube({{{x, -49, 992}, 9.0f},
                  {{x, -42, 977}, 8.5f},
                  {{x, -31, 961}, 7.0f},
                  {{x, -18, 944}, 6.0f},
                  {{x, -8, 928}, 5.0f},
                  {{x, -5, 913}, 3.6f},
                  {{x, -2, 901}, 3.0f},
                  {{x, 4, 893}, 3.0f}},
                 2.0f);
  bone.carveTubePair(
      {{{x + 29, -70, 950}, 7.0f}, {{x + 23, -45, 958}, 5.6f}, {{x + 22, -18, 966}, 4.2f}}, 3.0f);
  bone.carveTubePair(
      {{{x + 23, -54, 936}, 6.5f}, {{x + 20, -29, 944}, 5.0f}, {{x + 19, -6, 951}, 4.0f}}, 3.0f);
  bone.carveTubePair(
      {{{x + 20, -36, 923}, 5.5f}, {{x + 18, -14, 930}, 4.4f}, {{x + 17, 4, 934}, 3.6f}}, 2.5f);
  bone.carveTubePair(
      {{{x + 17, -26, 909}, 4.5f}, {{x + 15.5f, -9, 912}, 3.3f}, {{x + 15, 6, 914}, 3.2f}}, 2.0f);
}

void addCoccyx(Sculpture& bone) {
  // The coccyx has four pieces, each smaller than the one above, the first with transverse
  // processes and horns.
  const auto piece = [&bone](const glm::vec3& centre, const glm::vec3& semiAxes) {
    const Blob blob(centre, semiAxes, {-14, 0, 0});
    bone.add([blob](const glm::vec3& p) { return blob.distance(p); }, blob.bounds(), 3.0f);
  };
  piece({x, -10.3f, 889}, {7.6f, 4.2f, 6});
  piece({x, -11.2f, 880.2f}, {11, 4.6f, 6.4f});
  bone.addTubePair({{{x + 4, -11.3f, 881.5f}, 4},
                    {{x + 10, -12, 881.5f}, 3.5f},
                    {{x + 15, -12.8f, 880.5f}, 2.7f}},
                   3.5f);
  bone.addTubePair({{{x + 4.5f, -9, 881}, 3}, {{x + 5.5f, -6.5f, 888}, 2}}, 4.0f);
  piece({x, -12.8f, 869.3f}, {10.2f, 4.2f, 5.4f});
  piece({x, -15.3f, 861}, {7.2f, 3.9f, 4.6f});
  piece({x, -18.2f, 855}, {5.2f, 3.6f, 3.9f});
  piece({x, -20.4f, 851.6f}, {3.3f, 3.1f, 2.7f});
}
}  // namespace

Sculpture sacrum() {
  Sculpture bone(pelvisMiddle);
  addBodies(bone);
  addLateralParts(bone);
  addBack(bone);
  carveForamina(bone);
  addCoccyx(bone);
  return bone;
}

}  // namespace sline::model
