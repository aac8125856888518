// SPDX-License-Identifier: Apache-2.0
// Landmarks, radii and half-thicknesses in millimetres, set by hand from the measures of one body
// (BodyParts3D) and from what anatomy textbooks say of the hip bone.
#include "model/demo/hip_bone.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {
/// The wing: from the crest down to the body, columns from the anterior to the posterior border.
void addWing(Sculpture& bone) {
  bone.addPlate({{
                     // the crest, from the anterior superior to the posterior superior spine
                     {{140, -148, 971}, 5.0f},
                     {{148, -119, 1001}, 6.5f},
                     {{137, -88, 1029}, 4.5f},
                     {{112, -68, 1034}, 4.0f},
                     {{80, -49, 1028}, 4.5f},
                     {{53, -17, 1000}, 7.5f},
                     // the upper fossa
                     {{137, -142, 958}, 4.5f},
                     {{137, -117, 984}, 4.8f},
                     {{127, -88, 1003}, 5.0f},
                     {{105, -71, 1006}, 3.0f},
                     {{78, -54, 1004}, 5.0f},
                     {{51, -16, 984}, 8.5f},
                     // the lower fossa and the auricular surface
                     {{128, -130, 945}, 4.5f},
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
                     {{53, -34, 945}, 5.0f},
                     // the body above the cup, back to the greater sciatic notch
                     {{113, -115, 914}, 5.5f},
                     {{109, -104, 920}, 10.0f},
                     {{101, -93, 922}, 13.0f},
                     {{91, -82, 924}, 13.0f},
                     {{80, -71, 928}, 10.5f},
                     {{70, -61, 931}, 4.5f},
                     {{110, -110, 904}, 5.0f},
                     {{106, -105, 905}, 10.0f},
                     {{100, -95, 906}, 14.0f},
                     {{92, -83, 907}, 16.0f},
                     {{83, -70, 909}, 13.0f},
                     {{71, -59, 911}, 6.0f},
                 },
                 6},
                1.0f);
  // Anterior superior and anterior inferior iliac spines.
  bone.addTube({{{145, -135, 985}, 4.5f}, {{142, -144, 976}, 5.5f}, {{139, -147, 968}, 5.0f}},
               4.0f);
  bone.addTube({{{120, -121, 931}, 4.5f},
                {{117, -119, 923}, 6.5f},
                {{113, -116, 914}, 6.0f},
                {{110, -108, 906}, 5.0f}},
               5.0f);
}

/// The medial wall between the pelvic inlet and the foramen, and the sciatic border.
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
  bone.addTube({{{68, -61, 931}, 4.0f},
                {{65, -55, 914}, 4.0f},
                {{61, -50, 900}, 4.0f},
                {{59, -48, 884}, 4.5f},
                {{63, -49, 872}, 6.0f}},
               4.0f);
  // The ischial spine, between the greater and the lesser sciatic notch.
  bone.addTube({{{62, -55, 894}, 5.5f}, {{56, -47, 889}, 3.6f}, {{50, -42, 887}, 2.0f}}, 5.0f);
  // The posterior inferior spine, above the greater sciatic notch.
  bone.addTube({{{54, -26, 955}, 6.0f}, {{53, -35, 944}, 5.0f}, {{58, -43, 942}, 4.5f}}, 5.0f);
  // The arcuate line.
  bone.addTube({{{76, -54, 1012}, 2.5f},
                {{70, -59, 990}, 4.0f},
                {{71, -68, 966}, 5.0f},
                {{72, -78, 947}, 5.5f},
                {{76, -87, 930}, 6.0f},
                {{74, -98, 914}, 6.0f},
                {{64, -112, 899}, 4.5f}},
               10.0f);
}

void addPubis(Sculpture& bone) {
  bone.addTube({{{90, -112, 896}, 11.0f},
                {{70, -115, 889}, 9.5f},
                {{52, -122, 880}, 8.0f},
                {{34, -131, 872}, 7.0f},
                {{20, -137, 866}, 8.0f}},
               6.0f);
  // The pecten, from the arcuate line to the pubic tubercle.
  bone.addTube({{{66, -107, 906}, 4.5f},
                {{57, -116, 894}, 4.0f},
                {{45, -126, 884}, 3.5f},
                {{33, -136, 877}, 3.0f},
                {{21, -145, 870}, 5.0f}},
               5.0f);
  bone.addPlate({{
                     {{8, -141, 866}, 8.0f},
                     {{18, -138, 866}, 9.0f},
                     {{28, -132, 868}, 7.5f},
                     {{9, -130, 857}, 8.0f},
                     {{17, -128, 857}, 7.5f},
                     {{26, -122, 858}, 5.5f},
                     {{11, -118, 846}, 6.0f},
                     {{17, -117, 846}, 6.0f},
                     {{24, -112, 847}, 5.0f},
                 },
                 3},
                6.0f);
  // The inferior rami, a band: its lower border first, the border of the foramen second.
  bone.addPlate({{
                     {{13, -119, 846}, 5.5f},
                     {{20, -108, 836}, 5.0f},
                     {{29, -97, 829}, 4.5f},
                     {{40, -84, 825}, 4.5f},
                     {{51, -71, 823}, 6.0f},
                     {{60, -59, 826}, 8.0f},
                     {{21, -118, 852}, 4.5f},
                     {{27, -108, 845}, 4.0f},
                     {{34, -97, 838}, 3.5f},
                     {{44, -84, 834}, 4.0f},
                     {{56, -70, 835}, 6.0f},
                     {{63, -60, 840}, 8.0f},
                 },
                 6},
                6.0f);
}

void addIschium(Sculpture& bone) {
  bone.addTube({{{72, -69, 890}, 11.0f},
                {{71, -61, 875}, 13.0f},
                {{70, -57, 860}, 14.0f},
                {{67, -54, 845}, 14.0f},
                {{62, -56, 834}, 13.0f}},
               6.0f);
  // Behind the cup.
  bone.addTube({{{78, -63, 910}, 9.0f},
                {{84, -63, 895}, 7.5f},
                {{82, -61, 882}, 9.0f},
                {{76, -58, 868}, 11.0f}},
               8.0f);
  // The tuberosity: what one sits on.
  bone.addTube({{{73, -53, 872}, 8.0f},
                {{73, -47, 858}, 9.5f},
                {{70, -46, 843}, 10.5f},
                {{60, -53, 829}, 10.0f},
                {{47, -64, 824}, 7.0f}},
               6.0f);
}

/// Radius of the cup's articular surface: the femoral head and two layers of cartilage.
constexpr float cupRadius = 26.5f;

/// The cup opens outwards, downwards and a little forwards; its rim is open below, at the notch.
void addCup(Sculpture& bone) {
  const glm::vec3 axis = glm::normalize(glm::vec3(0.79f, -0.22f, -0.57f));
  const glm::vec3 centre = leftHipJoint;
  const glm::vec3 down =
      glm::normalize(glm::vec3(0, -0.6f, -1) - glm::dot(glm::vec3(0, -0.6f, -1), axis) * axis);
  const auto mass = [=](const glm::vec3& p) {
    const glm::vec3 q = p - centre;
    return blendedDifference(glm::length(q) - 31.0f, 1.5f - glm::dot(q, axis), 2.0f);
  };
  bone.add(mass, {centre - 32.0f, centre + 32.0f}, 8.0f);
  bone.carve([=](const glm::vec3& p) { return glm::length(p - centre) - cupRadius; }, 2.0f);
  // The fossa in the floor of the cup and the notch through which it opens below.
  bone.carveTube({{centre - 17.0f * axis - 3.0f * down, 11.5f},
                  {centre - 14.0f * axis + 9.0f * down, 10.0f},
                  {centre - 4.0f * axis + 27.0f * down, 7.0f}},
                 3.0f);
}

/// The face that looks at the other pubic bone is flat; the obturator foramen has a sharp border.
void finish(Sculpture& bone) {
  bone.cut({3.0f, 0, 0}, {-1, 0, 0.0f}, 2.5f);
}
}  // namespace

Sculpture leftHipBone() {
  Sculpture bone;
  addWing(bone);
  addBody(bone);
  addPubis(bone);
  addIschium(bone);
  addCup(bone);
  finish(bone);
  return bone;
}

}  // namespace sline::model
