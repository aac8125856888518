// SPDX-License-Identifier: Apache-2.0
// Models the vertebra by hand from the measures of one body (BodyParts3D) and from anatomy
// textbooks.
#include "model/demo/pelvis/lumbar_vertebra.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/demo/pelvis/bones.h"

namespace sline::model {

float VertebralBody::distance(const glm::vec3& p) const {
  const float angle = tilt * 3.14159265f / 180.0f;
  const glm::vec3 axis(0.0f, -std::sin(angle), std::cos(angle));
  const glm::vec3 back(0.0f, std::cos(angle), std::sin(angle));
  const glm::vec3 q = p - centre;
  const float u = q.x;
  const float v = glm::dot(q, back);
  const float w = glm::dot(q, axis);
  const float narrower = waist * std::max(0.0f, 1.0f - w * w / (halfHeight * halfHeight));
  const float outline = ellipsoid({u, v, 0.0f}, {halfWidth - narrower, halfDepth - narrower, 1e3f});
  // The body is slightly hollow behind, for the vertebral canal.
  const float behind = v - 0.95f * halfDepth - 0.004f * u * u;
  const float side = blendedDifference(outline, -behind, 10.0f);
  const float height = halfHeight - 0.5f * wedge * v / (2.0f * halfDepth) +
                       hollow * ((u * u + v * v) / (halfWidth * halfWidth) - 0.5f);
  return blendedDifference(side, height - std::abs(w), 3.0f);
}

Box VertebralBody::bounds() const {
  const float reach = std::hypot(halfDepth, halfHeight + wedge) + std::max(0.0f, -waist);
  return {centre - glm::vec3(halfWidth + std::max(0.0f, -waist), reach, reach),
          centre + glm::vec3(halfWidth + std::max(0.0f, -waist), reach, reach)};
}

namespace {
void addArch(Sculpture& bone) {
  constexpr float x = pelvisMiddle;
  // These are the pedicles.
  bone.addTubePair(
      {{{x + 18, -78, 1011}, 7.0f}, {{x + 21, -68, 1014}, 6.5f}, {{x + 23, -60, 1014}, 6.0f}},
      5.0f);
  // The laminae run from the isthmus to the root of the spinous process.
  bone.addPlatePair({{{{x + 22, -58, 1018}, 3.5f},
                      {{x + 12, -51, 1017}, 3.0f},
                      {{x, -44, 1016}, 2.8f},
                      {{x + 22, -54, 1010}, 4.0f},
                      {{x + 12, -48, 1010}, 3.2f},
                      {{x, -42, 1010}, 3.0f},
                      {{x + 20, -50, 1003}, 3.5f},
                      {{x + 12, -47, 1004}, 2.6f},
                      {{x, -41, 1005}, 2.8f}},
                     3},
                    4.0f);
  bone.addPlate({{{{x, -45, 1016}, 2.8f},
                  {{x, -36, 1016.5f}, 2.4f},
                  {{x, -28, 1016}, 3.2f},
                  {{x, -44, 1010}, 3.2f},
                  {{x, -35, 1009}, 2.8f},
                  {{x, -27, 1009}, 4.0f},
                  {{x, -42, 1005}, 2.8f},
                  {{x, -35, 1004}, 2.6f},
                  {{x, -28, 1004.5f}, 3.2f}},
                 3},
                4.0f);
}

void addProcesses(Sculpture& bone) {
  constexpr float x = pelvisMiddle;
  // The transverse processes are stout, as they carry the iliolumbar ligaments.
  bone.addPlatePair({{{{x + 24, -68, 1018}, 5.0f},
                      {{x + 37, -66, 1020}, 4.0f},
                      {{x + 49, -64, 1025}, 3.6f},
                      {{x + 24, -70, 1010}, 5.5f},
                      {{x + 36, -67, 1013}, 4.5f},
                      {{x + 49, -65, 1021}, 3.6f}},
                     3},
                    6.0f);
  // The superior articular processes face back and inwards, the inferior ones forwards and
  // outwards.
  bone.addPlatePair({{{{x + 19, -64, 1030}, 2.2f},
                      {{x + 24, -62, 1032}, 2.6f},
                      {{x + 28, -57, 1030}, 2.4f},
                      {{x + 19, -65, 1022}, 2.6f},
                      {{x + 25, -63, 1022}, 3.4f},
                      {{x + 29, -56, 1022}, 3.2f},
                      {{x + 20, -63, 1014}, 4.0f},
                      {{x + 25, -61, 1014}, 5.0f},
                      {{x + 27, -57, 1014}, 4.0f}},
                     3},
                    3.5f);
  bone.addPlatePair({{{{x + 15, -48, 1006}, 3.4f},
                      {{x + 23, -51, 1006}, 3.6f},
                      {{x + 17, -46, 999}, 3.4f},
                      {{x + 23, -49, 999}, 3.4f},
                      {{x + 19, -46, 994}, 2.8f},
                      {{x + 22, -48, 994}, 2.8f}},
                     2},
                    3.5f);
}
}  // namespace

Sculpture fifthLumbarVertebra() {
  const VertebralBody body{.centre = {pelvisMiddle, -86.3f, 1004.2f},
                           .tilt = 23.0f,
                           .halfWidth = 27.0f,
                           .halfDepth = 20.0f,
                           .halfHeight = 14.6f,
                           .wedge = 3.0f,
                           .waist = 3.0f,
                           .hollow = 0.9f};
  Sculpture bone(pelvisMiddle);
  bone.add([body](const glm::vec3& p) { return body.distance(p); }, body.bounds(), 1.0f);
  addArch(bone);
  addProcesses(bone);
  return bone;
}

Sculpture lumbosacralDisc() {
  const VertebralBody disc{.centre = {pelvisMiddle, -77.9f, 985.6f},
                           .tilt = 25.8f,
                           .halfWidth = 25.0f,
                           .halfDepth = 20.0f,
                           .halfHeight = 7.1f,
                           .wedge = 0.3f,
                           .waist = -1.2f,
                           .hollow = -0.9f};
  Sculpture shape(pelvisMiddle);
  shape.add([disc](const glm::vec3& p) { return disc.distance(p); }, disc.bounds(), 1.0f);
  return shape;
}

}  // namespace sline::model
