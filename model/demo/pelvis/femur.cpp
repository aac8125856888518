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
  // The neck is taller than it is thick and has two strands, the lower one the calcar. It points
  // forward by some 11 degrees and stands at some 126 degrees to the shaft.
  bone.addTube(
      {{{97, -87, 879}, 14.8f}, {{111.5f, -85, 866.4f}, 12.0f}, {{127.5f, -81.5f, 854.6f}, 13.2f}},
      7.0f);
  bone.addTube({{{95, -88, 872}, 13.0f},
                {{106, -85.7f, 856.5f}, 11.3f},
                {{113.8f, -83, 838.5f}, 12.7f},
                {{119, -81.5f, 820}, 15.5f}},
               7.0f);
}

void addTrochanters(Sculpture& bone) {
  // The greater trochanter has a flat top, whose tip leans over the fossa, and a flat outer face.
  bone.addPlate({{{{142, -94, 866}, 6.0f},
                  {{149, -80, 868}, 6.5f},
                  {{139, -65, 871}, 5.0f},
                  {{147, -92, 853}, 8.5f},
                  {{152, -79, 853}, 9.5f},
                  {{141, -65, 853}, 6.5f},
                  {{142, -87, 838}, 11.0f},
                  {{146, -79, 838}, 11.5f},
                  {{137, -67, 838}, 8.0f}},
                 3},
                5.0f);
  bone.addTube({{{144, -79, 846}, 14.0f}, {{139, -79, 829}, 14.5f}, {{131, -82, 808}, 14.0f}},
               8.0f);
  // The intertrochanteric crest runs behind, down to the lesser trochanter.
  bone.addTube({{{137, -63, 864}, 4.8f},
                {{133, -62.5f, 846}, 5.0f},
                {{124, -66.5f, 829}, 5.5f},
                {{112, -73, 815}, 7.0f}},
               5.0f);
  // The lesser trochanter is a knob, steep below.
  bone.addTube({{{118, -81, 822}, 10.5f}, {{109, -74.5f, 813}, 8.6f}, {{106, -72.5f, 808}, 7.0f}},
               5.0f);
  // The intertrochanteric line lies in front.
  bone.addTube({{{142, -93, 862}, 5.0f},
                {{134, -96, 851}, 3.0f},
                {{122, -95, 834}, 2.5f},
                {{112, -90, 818}, 2.5f}},
               8.0f);
  // The fossa lies behind the neck, under the tip of the greater trochanter.
  bone.carveTube({{{122, -59, 881}, 9.0f}, {{129, -68, 867}, 6.5f}, {{127, -67, 856}, 4.5f}}, 6.0f);
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
