// SPDX-License-Identifier: Apache-2.0
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

/// Calls `body` with what is known of each visible structure, until it returns false.
template <class Body>
void forEachVisible(const Scene& scene, const Body& body) {
  for (const Node& node : scene.nodes())
    if (!node.isGroup() && scene.resolve(node.id).visible && !body(node.provenance))
      return;
}

}  // namespace

bool isUnitDoubted(const Provenance& from) {
  return from.unitReason.ends_with(unlikelySizes);
}

std::string_view symbolOf(DrawnUnit unit) {
  switch (unit) {
    case DrawnUnit::angstrom:
      return "Å";
    case DrawnUnit::doubtedMillimetre:
      return "mm?";
    case DrawnUnit::millimetre:
      break;
  }
  return "mm";
}

DrawnUnit drawnUnit(const Scene& scene) {
  bool molecules = false;
  bool others = false;
  bool doubted = false;
  forEachVisible(scene, [&](const Provenance& from) {
    doubted = doubted || isUnitDoubted(from);
    const bool molecule = from.unitReason == angstromReason;
    molecules = molecules || molecule;
    others = others || (!molecule &&
                        (!from.file.empty() || (!from.frame.empty() && from.frame != fileFrame)));
    return !doubted;
  });
  if (doubted)
    return DrawnUnit::doubtedMillimetre;
  return molecules && !others ? DrawnUnit::angstrom : DrawnUnit::millimetre;
}

bool hasSides(const Scene& scene) {
  bool any = false;
  bool known = false;
  forEachVisible(scene, [&](const Provenance& from) {
    any = true;
    known = from.frame != fileFrame;
    return !known;
  });
  return known || !any;
}

}  // namespace sline::model
