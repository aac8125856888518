// SPDX-License-Identifier: Apache-2.0
#include "model/demo/abdomen_parts.h"

namespace sline::model {

std::vector<DemoStructure> abdomenGlands() {
  return {{.name = "liver",
           .groups = {"Digestive system"},
           .colour = {138, 69, 38},
           .gamma = Gamma::clamped(4.0f),
           .field = liverField(),
           .box = {{-150, -100, -75}, {100, 86, 120}},
           .edge = 2.2f}};
}

}  // namespace sline::model
