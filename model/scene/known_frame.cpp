// SPDX-License-Identifier: Apache-2.0
#include "model/scene/known_frame.h"

#include <algorithm>
#include <charconv>

namespace sline::model {

namespace {

/// Calls `body` with what is known of each visible structure, until it returns false.
template <class Body>
void forEachVisible(const Scene& scene, const Body& body) {
  for (const Node& node : scene.nodes())
    if (!node.isGroup() && scene.resolve(node.id).visible && !body(node.provenance))
      return;
}

/// Keeps the less sure of the two.
void add(SideEvidence& to, const SideEvidence& more) {
  to.sides = std::max(to.sides, more.sides);
  to.front = std::max(to.front, more.front);
  to.up = std::max(to.up, more.up);
}

/// Takes a number from the beginning of a text.
int takeNumber(std::string_view& text) {
  int number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(std::size_t(end.ptr - text.data()));
  return number;
}

}  // namespace

bool isUnitDoubted(const Provenance& from) {
  return !isSure(from.unitEvidence);
}

std::optional<Evidence> evidenceNamed(std::string_view name) {
  const auto found = std::find(evidenceNames.begin(), evidenceNames.end(), name);
  if (found == evidenceNames.end())
    return std::nullopt;
  return Evidence(found - evidenceNames.begin());
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
  if (doubted || (molecules && others))
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

bool isNameDoubted(const Node& node) {
  return !node.isGroup() && !isSure(node.provenance.nameEvidence);
}

std::string markedName(const Node& node) {
  return isNameDoubted(node) ? node.name + std::string(doubtMark) : node.name;
}

bool namesInDoubt(const Scene& scene, const Annotation& annotation) {
  const auto* point = annotation.kind == AnnotationKind::distance || annotation.anchors.empty()
                          ? nullptr
                          : std::get_if<SurfacePoint>(&annotation.anchors.front());
  return point && scene.find(point->structure) && isNameDoubted(*scene.find(point->structure));
}

bool KnownSides::inDoubt(int axis) const {
  return any && !isSure(axis == 0 ? evidence.sides : axis == 1 ? evidence.front : evidence.up);
}

KnownSides knownSides(const Scene& scene) {
  KnownSides known{.any = hasSides(scene), .evidence = {}};
  // This is asked for each picture: what adds no doubt need not be looked for.
  for (const Node& node : scene.nodes())
    if (const SideEvidence& own = node.provenance.evidence;
        !node.isGroup() &&
        (own.sides > known.evidence.sides || own.front > known.evidence.front ||
         own.up > known.evidence.up) &&
        scene.resolve(node.id).visible)
      add(known.evidence, own);
  for (const Scan& scan : scene.scans())
    add(known.evidence, scan.evidence);
  return known;
}

SideEvidence evidenceOfReason(std::string_view frameReason) {
  constexpr SideEvidence assumed{Evidence::assumed, Evidence::assumed};
  if (frameReason == nothingTellsFrame)
    return assumed;
  if (frameReason == chosenReason)
    return {Evidence::settled, Evidence::settled};
  if (!frameReason.starts_with(votedFrame))
    return {};
  std::string_view rest = frameReason.substr(votedFrame.size());
  const int votes = takeNumber(rest);
  if (!rest.starts_with(" of "))
    return {};
  rest.remove_prefix(4);
  const int all = takeNumber(rest);
  // A single vote may have been that of one name alone.
  return all > 1 && isClearVote(all - votes, all) ? SideEvidence{Evidence::voted, Evidence::voted}
                                                  : assumed;
}

}  // namespace sline::model
