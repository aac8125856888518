// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/implausible_sizes.h"

#include <algorithm>
#include <sstream>

#include "model/geometry/scale_limits.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

/// Returns the longest side of the box with its unit, "1.5 km" or "2e-06 mm".
std::string lengthText(const Box& box) {
  constexpr float metre = 1e3f;
  constexpr float kilometre = 1e6f;
  const glm::vec3 size = box.size();
  const float across = std::max({size.x, size.y, size.z});
  const float unit = across >= kilometre ? kilometre : across >= metre ? metre : 1.0f;
  std::ostringstream text;
  text.precision(3);
  text << across / unit << (unit == kilometre ? " km" : unit == metre ? " m" : " mm");
  return text.str();
}

}  // namespace

std::string implausibleSizesText(const Scene& scene) {
  const Node* first = nullptr;
  std::size_t more = 0;
  for (const Node& node : scene.nodes()) {
    if (node.isGroup() || isPlausibleSize(node.mesh->bounds()))
      continue;
    more += first ? 1 : 0;
    first = first ? first : &node;
  }
  if (!first)
    return {};
  std::string text = '"' + first->name + "\" is " + lengthText(first->mesh->bounds()) + " across";
  if (more > 0)
    text += ", and " + std::to_string(more) + (more == 1 ? " other is" : " others are") +
            " as unlikely";
  return text + ": an implausible size, check the unit";
}

std::string mixedScalesText(const Scene& scene) {
  const Node* molecule = nullptr;
  const Node* other = nullptr;
  for (const Node& node : scene.nodes())
    if (!node.isGroup() && !node.provenance.file.empty())
      (node.provenance.unitReason == angstromReason ? molecule : other) = &node;
  if (!molecule || !other)
    return {};
  return "molecules are drawn with 1 Å as 1 mm, ten million times as large as \"" + other->name +
         "\" beside them; no scale bar holds for both, so open them apart";
}

}  // namespace sline::model
