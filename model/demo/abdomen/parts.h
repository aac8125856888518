// SPDX-License-Identifier: Apache-2.0
// Declares the organs of the demo abdomen, by system. Their frame is LPS in millimetres: x = 0 is
// the midline, z = 0 the transpyloric plane (lower border of the first lumbar vertebra), y = 0
// about the middle of the body's depth, just behind the front of the vertebral bodies. Sizes are
// those that textbooks of anatomy give for an adult.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

std::vector<DemoStructure> abdomenBones();
std::vector<DemoStructure> abdomenMuscles();
/// Models gallbladder and bile ducts, adrenal glands, pancreas.
std::vector<DemoStructure> abdomenGlands();
std::vector<DemoStructure> abdomenSpleenAndLiver();
/// Models duodenum, stomach, colon.
std::vector<DemoStructure> abdomenGut();
/// Models jejunum and ileum in the room that the given structures leave.
std::vector<DemoStructure> abdomenBowel(const std::vector<DemoStructure>& there);
std::vector<DemoStructure> abdomenUrinary();
std::vector<DemoStructure> abdomenArteries();
std::vector<DemoStructure> abdomenVeins();

/// The place where the duodenum ends and the jejunum begins, and the unit vector on along the
/// bowel.
inline constexpr glm::vec3 duodenojejunalFlexure{50, -38, -30};
inline constexpr glm::vec3 intoJejunum{0.50f, -0.36f, -0.79f};

/// Returns the liver before its neighbours press into it.
Field liverField();

}  // namespace sline::model
