// SPDX-License-Identifier: Apache-2.0
#include "model/demo/pelvis/bones.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "model/demo/pelvis/femur.h"
#include "model/demo/pelvis/hip_bone.h"
#include "model/demo/pelvis/lumbar_vertebra.h"
#include "model/demo/pelvis/parts.h"
#include "model/demo/pelvis/sacrum.h"

namespace sline::model {

namespace {
constexpr Colour dryBoneColour{226, 211, 178};
constexpr Colour cartilageColour{172, 200, 206};

Shape reflected(const Shape& shape) {
  return {mirrored(shape.field, pelvisMiddle), mirrored(shape.box, pelvisMiddle)};
}

/// Models the fibrous plate between the pubic bones.
Sculpture pubicSymphysis() {
  constexpr float x = pelvisMiddle;
  Sculpture disc;
  disc.addPlate({{{{x, -140, 863.5f}, 4.4f},
                  {{x, -135.5f, 868.5f}, 4.4f},
                  {{x, -131, 854}, 4.4f},
                  {{x, -126, 859}, 4.4f},
                  {{x, -121, 847}, 4.4f},
                  {{x, -118, 850}, 4.4f}},
                 2},
                1.0f);
  return disc;
}

DemoStructure structure(const char* name, Shape shape, Colour colour, float edge) {
  return {.name = name,
          .groups = {"Bones"},
          .colour = colour,
          .gamma = Gamma::clamped(1.2f),
          .fill = Fill::paper,
          .inkColour = boneInk,
          .field = std::move(shape.field),
          .box = shape.box,
          .edge = edge};
}

DemoStructure female(DemoStructure s) {
  s.field = [male = std::move(s.field)](const glm::vec3& p) { return male(fromFemalePelvis(p)); };
  s.box = grown(s.box, 16.0f);
  return s;
}
}  // namespace

glm::vec3 fromFemalePelvis(const glm::vec3& p) {
  // Everything lies lower, measured from the hip joints, and is moved aside by up to `wider`, the
  // more the lower it lies, so that the pubic arch opens.
  constexpr float lower = 1.06f;
  constexpr float arch = 40.0f;  // mm from the midline where most of the sideways shift is reached
  const float aside = p.x - pelvisMiddle;
  const float wider = 5.0f + 6.5f * glm::smoothstep(0.0f, 1.0f, (885.0f - p.z) / 60.0f);
  const float hipLevel = leftHipJoint.z;
  return {p.x - wider * std::tanh(aside / arch), p.y, hipLevel + lower * (p.z - hipLevel)};
}

glm::vec3 toFemalePelvis(const glm::vec3& p) {
  // The map's shift changes less than the place does, so substituting repeatedly converges.
  glm::vec3 q = p;
  for (int step = 0; step < 12; ++step)
    q += p - fromFemalePelvis(q);
  return q;
}

std::vector<DemoStructure> pelvisBones(Sex sex, const std::stop_token& stop) {
  const auto shapeOf = [&stop](const Sculpture& sculpture, SampledField::Fineness fineness) {
    return Shape{sculpture.sampled(fineness, stop), grown(sculpture.bounds(), 4.0f)};
  };
  const Shape hipBone = shapeOf(leftHipBone(), {1.6f, 2.3f});
  const Shape femur = shapeOf(leftFemur(), {1.8f, 2.2f});
  std::vector<DemoStructure> bones;
  bones.push_back(structure("left hip bone", hipBone, dryBoneColour, 2.3f));
  bones.push_back(structure("right hip bone", reflected(hipBone), dryBoneColour, 2.3f));
  // The sacroiliac joints are as narrow as the cut, since the wings are modelled into the hip
  // bones.
  DemoStructure wedge = structure("sacrum", shapeOf(sacrum(), {1.3f, 1.8f}), dryBoneColour, 1.8f);
  wedge.givesWayTo = {"left hip bone", "right hip bone"};
  wedge.gap = 1.0f;
  wedge.rounding = 1.5f;
  bones.push_back(std::move(wedge));
  bones.push_back(structure("fifth lumbar vertebra", shapeOf(fifthLumbarVertebra(), {1.2f, 1.3f}),
                            dryBoneColour, 1.8f));
  bones.push_back(structure("left femur", femur, dryBoneColour, 2.4f));
  bones.push_back(structure("right femur", reflected(femur), dryBoneColour, 2.4f));
  DemoStructure disc = structure("fifth lumbar intervertebral disc",
                                 shapeOf(lumbosacralDisc(), {1.4f, 1.0f}), cartilageColour, 1.8f);
  disc.givesWayTo = {"sacrum", "fifth lumbar vertebra"};
  disc.gap = 0.2f;
  bones.push_back(std::move(disc));
  DemoStructure symphysis =
      structure("pubic symphysis", shapeOf(pubicSymphysis(), {1.4f, 1.0f}), cartilageColour, 1.5f);
  symphysis.givesWayTo = {"left hip bone", "right hip bone"};
  symphysis.gap = 0.2f;
  bones.push_back(std::move(symphysis));
  if (sex == Sex::female)
    std::transform(bones.begin(), bones.end(), bones.begin(), female);
  return bones;
}

}  // namespace sline::model
