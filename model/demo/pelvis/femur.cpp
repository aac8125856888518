// SPDX-License-Identifier: Apache-2.0
// Models the femur by hand from the measures of one body (BodyParts3D); names of ridges after
// textbooks.
#include "model/demo/pelvis/femur.h"

#include <glm/geometric.hpp>

#include "model/demo/pelvis/hip_bone.h"

namespace sline::model {

namespace {
constexpr float headRadius = 24.4f;

void addShaft(Sculpture& bone) {
  bone.addTube({{{136, -80, 846}, 16.0f},
                {{131, -80, 834}, 18.5f},
                {{126, -81, 818}, 19.0f},
                {{124.5f, -84, 800}, 17.8f},
                {{122.5f, -89, 784}, 16.2f},
                {{121, -93, 767}, 15.2f},
                {{119, -97, 750}, 14.8f}},
               6.0f);
  // The neck is taller than it is thick and has two strands, the lower one the calcar.
  bone.addTube({{{97, -87, 879}, 14.5f}, {{111, -86, 865}, 12.0f}, {{126, -85, 853}, 13.0f}}, 8.0f);
  bone.addTube({{{95, -88, 872}, 13.0f},
                {{105, -86, 856}, 12.5f},
                {{113, -84, 838}, 13.0f},
                {{119, -83, 820}, 15.5f}},
               8.0f);
}

void addTrochanters(Sculpture& bone) {
  bone.addPlate({{{{143, -92, 865}, 6.5f},
                  {{147, -79, 870}, 7.0f},
                  {{139, -66, 870}, 6.0f},
                  {{147, -90, 852}, 9.0f},
                  {{150, -78, 853}, 10.5f},
                  {{139, -66, 852}, 8.0f},
                  {{142, -86, 838}, 11.0f},
                  {{145, -78, 838}, 12.0f},
                  {{136, -68, 838}, 9.0f}},
                 3},
                6.0f);
  bone.addTube({{{144, -79, 846}, 14.0f}, {{140, -79, 830}, 15.0f}, {{133, -81, 808}, 14.0f}},
               8.0f);
  // The intertrochanteric crest runs behind, down to the lesser trochanter.
  bone.addTube({{{136, -63, 862}, 5.0f},
                {{132, -63, 845}, 5.5f},
                {{123, -67, 827}, 6.0f},
                {{112, -73, 812}, 8.0f}},
               6.0f);
  bone.addTube({{{116, -80, 818}, 10.0f},
                {{108, -75, 809}, 7.5f},
                {{107, -76, 804}, 7.0f},
                {{113, -82, 790}, 7.0f}},
               8.0f);
  // The intertrochanteric line lies in front.
  bone.addTube({{{142, -93, 862}, 5.0f},
                {{134, -96, 851}, 3.0f},
                {{122, -95, 834}, 2.5f},
                {{112, -90, 818}, 2.5f}},
               8.0f);
  // The fossa lies behind the neck, under the tip of the greater trochanter.
  bone.carveTube({{{124, -60, 879}, 8.0f}, {{131, -70, 866}, 5.0f}}, 9.0f);
}
}  // namespace

Sculpture leftFemur() {
  Sculpture bone;
  addShaft(bone);
  addTrochanters(bone);
  const auto head = [](const glm::vec3& p) { return glm::distance(p, leftHipJoint) - headRadius; };
  bone.add(head, {leftHipJoint - headRadius, leftHipJoint + headRadius}, 5.0f);
  // The fovea holds the ligament of the head.
  const glm::vec3 fovea =
      leftHipJoint + headRadius * glm::normalize(glm::vec3(-0.93f, 0.3f, -0.1f));
  bone.carve([fovea](const glm::vec3& p) { return glm::distance(p, fovea) - 3.5f; }, 4.0f);
  bone.cut({0, 0, 770}, {0, 0, -1}, 3.0f);
  // The marrow cavity is open at the cut.
  bone.carveTube({{{119, -97, 752}, 7.0f}, {{121, -93, 768}, 7.0f}, {{122, -91, 776}, 5.0f}}, 2.5f);
  return bone;
}

}  // namespace sline::model
