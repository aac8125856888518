// SPDX-License-Identifier: Apache-2.0
// Models the hip bone by hand: landmarks, radii and half-thicknesses in millimetres come from the
// measures of one body (BodyParts3D) and from anatomy textbooks.
#include "model/demo/pelvis/hip_bone.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {
/// Adds the wing: from the crest down to the body, columns from the anterior to the posterior
/// border.
void addWing(Sculpture& bone) {
  bone.addPlate({{
                     // the crest, from the anterior superior to the posterior superior spine
                     {{140, -147, 972}, 4.5f},
                     {{147, -119, 1001}, 5.0f},
                     {{136, -88, 1027}, 4.3f},
                     {{111, -68, 1033}, 3.8f},
                     {{80, -49, 1027}, 4.2f},
                     {{58, -24, 1006}, 6.0f},
                     // the upper fossa
                     {{136, -140, 959}, 4.5f},
                     {{137, -117, 984}, 4.8f},
                     {{127, -88, 1003}, 5.0f},
                     {{105, -71, 1006}, 3.0f},
                     {{78, -54, 1004}, 5.0f},
                     {{50, -14, 986}, 8.5f},
                     // the lower fossa and the auricular surface
                     {{124, -125, 944}, 4.8f},
                     {{126, -110, 962}, 5.0f},
                     {{116, -90, 975}, 4.5f},
                     {{94, -72, 977}, 4.2f},
                     {{71, -54, 973}, 8.5f},
                     {{51, -23, 966}, 8.5f},
                     {{120, -121, 930}, 6.0f},
                     {{117, -107, 942}, 7.5f},
                     {{108, -92, 948}, 8.0f},
                     {{91, -75, 950}, 8.0f},
                     {{69, -56, 950}, 8.5f},
                     {{53, -36, 943.5f}, 5.0f},
                     // the body above the cup, back to the greater sciatic notch
                     {{112, -113, 912}, 5.5f},
                     {{107, -106, 920}, 10.5f},
                     {{101, -93, 922}, 13.0f},
                     {{91, -82, 924}, 13.0f},
                     {{80, -71, 928}, 10.5f},
                     {{72, -64, 934}, 4.5f},
                     {{110, -110, 904}, 5.0f},
                     {{103, -108, 905}, 10.5f},
                     {{100, -95, 906}, 14.0f},
                     {{92, -83, 907}, 16.0f},
                     {{83, -70, 909}, 13.0f},
                     {{71, -59, 911}, 6.0f},
                 },
                 6},
                1.0f);
}

/// Adds the crest and its spines; the sciatic notches' borders come with the body.
void addCrest(Sculpture& bone) {
  // The crest is thickest at its tubercle.
  bone.addTube({{{141, -147, 972}, 4.5f},
                {{145.5f, -135, 985}, 5.2f},
                {{148, -121, 999}, 6.1f},
                {{146, -105, 1012.5f}, 6.8f},
                {{137, -88, 1027.5f}, 5.8f},
                {{112, -68, 1033.5f}, 4.6f},
                {{80, -49, 1028}, 5.2f},
                {{60, -28, 1010}, 6.5f},
                {{52, -17, 994}, 7.5f},
                {{50, -14, 982}, 7.0f}},
               8.0f);
  // These are the anterior superior and anterior inferior iliac spines.
  bone.addTube({{{142.5f, -142, 978}, 4.8f}, {{140.5f, -146, 971}, 5.4f}, {{137, -143, 962}, 4.6f}},
               10.0f);
  bone.addTube({{{120, -120, 933}, 4.5f}, {{118, -120, 925}, 6.8f}, {{113, -115, 916}, 6.0f}},
               8.0f);
}

/// Adds the medial wall between the pelvic inlet and the foramen, and the sciatic border.
void addBody(Sculpture& bone) {
  bone.addPlate({{
                     {{79, -110, 906}, 7.0f},
                     {{79, -96, 912}, 9.0f},
                     {{77, -79, 917}, 9.0f},
                     {{71, -62, 922}, 5.0f},
                     {{67, -112, 893}, 6.0f},
                     {{66, -98, 897}, 5.0f},
                     {{67, -78, 897}, 5.0f},
                     {{63, -53, 901}, 5.0f},
                     {{63, -108, 882}, 5.0f},
                     {{61, -95, 881}, 4.0f},
                     {{62, -76, 880}, 5.0f},
                     {{61, -53, 880}, 6.0f},
                     {{66, -104, 876}, 4.0f},
                     {{62, -92, 874}, 4.0f},
                     {{62, -77, 865}, 6.0f},
                     {{63, -57, 863}, 8.0f},
                 },
                 4},
                6.0f);
  bone.addTube({{{70, -63, 932}, 4.0f},
                {{65, -55, 914}, 4.0f},
                {{61, -51, 899}, 4.0f},
                {{61, -52, 884}, 4.5f},
                {{64, -50, 873}, 5.5f},
                {{68, -50, 860}, 5.5f}},
               4.0f);
  // The ischial spine lies between the greater and the lesser sciatic notch.
  bone.addTube({{{63, -57, 897}, 7.0f}, {{57, -48.5f, 890}, 5.4f}, {{50.5f, -41.5f, 887.5f}, 3.3f}},
               5.0f);
  // The posterior inferior spine lies above the greater sciatic notch.
  bone.addTube({{{54, -27, 955}, 4.5f}, {{53, -37, 942}, 4.8f}, {{58, -46, 942}, 4.2f}}, 5.0f);
  // This is the arcuate line.
  bone.addTube({{{76, -55, 1008}, 1.5f},
                {{71.5f, -58, 990}, 3.4f},
                {{71, -67, 968}, 5.2f},
                {{72, -78, 947}, 5.5f},
                {{76, -87, 930}, 6.0f},
                {{74, -98, 914}, 6.0f},
                {{64, -112, 899}, 4.5f}},
               10.0f);
}

void addPubis(Sculpture& bone) {
  bone.addTube({{{100, -103, 903}, 9.0f},
                {{88, -111, 896}, 11.0f},
                {{70, -115, 887}, 10.5f},
                {{52, -122, 879}, 8.5f},
                {{34, -131, 872}, 7.0f},
                {{20, -137, 866}, 8.0f}},
               6.0f);
  // The pecten runs from the arcuate line to the pubic tubercle.
  bone.addTube({{{66, -107, 906}, 4.5f},
                {{57, -116, 894}, 4.0f},
                {{45, -126, 884}, 3.5f},
                {{33, -136, 877}, 3.0f},
                {{21, -145, 870}, 5.0f}},
               5.0f);
  bone.addPlate({{
                     {{9, -141, 866}, 7.5f},
                     {{18, -138, 866}, 9.0f},
                     {{28, -132, 868}, 7.5f},
                     {{10, -130, 857}, 7.5f},
                     {{17, -128, 857}, 7.5f},
                     {{26, -122, 858}, 5.5f},
                     {{12, -120, 849}, 6.0f},
                     {{17, -118, 848}, 6.0f},
                     {{23, -114, 850}, 5.0f},
                 },
                 3},
                6.0f);
  // The inferior rami are a band: its lower border first, the border of the foramen second.
  bone.addPlate({{
                     {{13, -123, 850}, 6.0f},
                     {{19, -109, 838}, 5.2f},
                     {{27, -96, 829}, 5.0f},
                     {{37, -82, 825}, 5.5f},
                     {{48, -69, 823.5f}, 6.5f},
                     {{58, -58, 826}, 8.0f},
                     {{21, -123, 857}, 5.0f},
                     {{26.5f, -109, 846}, 4.2f},
                     {{33, -97, 838}, 4.2f},
                     {{43, -83, 834}, 5.0f},
                     {{55, -69, 835}, 7.0f},
                     {{63, -60, 840}, 8.0f},
                 },
                 6},
                10.0f);
}

void addIschium(Sculpture& bone) {
  bone.addTube({{{74, -74, 896}, 11.0f},
                {{71, -61, 875}, 13.0f},
                {{70, -57, 860}, 14.0f},
                {{67, -54, 845}, 14.0f},
                {{62, -56, 834}, 13.0f}},
               6.0f);
  // This plate lies behind the cup.
  bone.addPlate({{{{63, -53, 903}, 5.0f},
                  {{80, -62, 903}, 7.0f},
                  {{97, -70, 903}, 7.0f},
                  {{63, -51, 891}, 5.0f},
                  {{79, -57, 891}, 7.0f},
                  {{94, -65, 890}, 5.5f},
                  {{67, -53, 873}, 7.0f},
                  {{76, -56, 873}, 9.0f},
                  {{86, -62, 873}, 6.0f}},
                 3},
                10.0f);
  // Below the cup is the groove over which the obturator externus turns.
  bone.addTube({{{85, -68, 873}, 5.0f}, {{79, -67, 863}, 7.5f}, {{72, -62, 852}, 10.0f}}, 8.0f);
  // The tuberosity is the part one sits on.
  bone.addTube({{{73, -53, 872}, 8.0f},
                {{73, -47, 858}, 9.5f},
                {{70, -46, 843}, 10.5f},
                {{60, -53, 829}, 10.0f},
                {{49, -63, 825}, 6.5f}},
               10.0f);
}

/// The radius of the cup's articular surface: the femoral head and two layers of cartilage.
constexpr float cupRadius = 27.5f;

/// Adds the cup, which opens outwards, downwards and a little forwards; below it opens through the
/// notch into the obturator foramen.
void addCup(Sculpture& bone) {
  const glm::vec3 axis = glm::normalize(glm::vec3(0.79f, -0.22f, -0.57f));
  const glm::vec3 below(0.0f, -0.55f, -0.85f);
  const glm::vec3 down = glm::normalize(below - glm::dot(below, axis) * axis);
  const glm::vec3 notch = glm::normalize(down - 0.25f * axis);
  const glm::vec3 centre = leftHipJoint + glm::vec3(1.5f, -0.5f, 2.0f);
  const auto mass = [=](const glm::vec3& p) {
    const glm::vec3 q = p - centre;
    const float half = blendedDifference(glm::length(q) - 32.5f, 1.0f - glm::dot(q, axis), 3.0f);
    return blendedDifference(half, 26.0f - glm::dot(q, notch), 3.0f);
  };
  bone.add(mass, {centre - 33.0f, centre + 33.0f}, 8.0f);
  bone.carve([=](const glm::vec3& p) { return glm::length(p - centre) - cupRadius; }, 2.0f);
  // The roof does not overhang the opening.
  bone.carveTube({{centre + 4.0f * axis, 26.5f}, {centre + 30.0f * axis, 31.0f}}, 4.0f);
  // The fossa lies in the floor of the cup; the notch leads out of it.

  bone.carveTube({{centre - 21.0f * axis - 2.0f * down, 13.0f},
                  {centre - 18.5f * axis + 9.0f * down, 12.5f},
                  {centre - 9.0f * axis + 24.0f * down, 9.0f}},
                 1.5f);
}

/// Flattens the face towards the other pubic bone and gives the obturator foramen a sharp border.
void finish(Sculpture& bone) {
  bone.cut({3.0f, 0, 0}, {-1, 0, 0.0f}, 2.5f);
}
}  // namespace

Sculpture leftHipBone() {
  Sculpture bone;
  addWing(bone);
  addCrest(bone);
  addBody(bone);
  addPubis(bone);
  addIschium(bone);
  addCup(bone);
  finish(bone);
  return bone;
}

}  // namespace sline::model
