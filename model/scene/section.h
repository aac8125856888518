// SPDX-License-Identifier: Apache-2.0
// Section planes: what of the scene is cut away so that its inside can be seen.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry/plane.h"
#include "model/scene/camera.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// Names a section for as long as the scene lives, through every edit and through undo.
struct SectionId {
  std::uint64_t value = 0;
  auto operator<=>(const SectionId&) const = default;
};

/// Cuts every structure at or below `scope`. Solids (see Surface) get a cut face in their colour
/// with an inked outline; sheets are cut open.
struct Section {
  SectionId id;
  std::string name;
  Plane plane;
  NodeId scope = rootId;
  bool enabled = true;
  bool hatched = false;  ///< strokes at 45° on the cut faces
  std::string unread;    ///< as Node::unread
  bool operator==(const Section&) const = default;
};

/// How many sections may cut one structure.
inline constexpr std::size_t maximumSections = 8;

/// The anatomical plane that has the given side to keep: sagittal for left and right, coronal for
/// anterior and posterior, axial for superior and inferior. `mm` is the plane's place along x, y or
/// z of LPS.
Plane anatomicalPlane(AnatomicalView kept, float mm);
/// 0 for the sides of a sagittal plane, 1 of a coronal, 2 of an axial one: its axis of LPS.
int axisOf(AnatomicalView side);

/// 0, 1 or 2 where the plane stands across the x, y or z axis of LPS; absent for an oblique one.
std::optional<int> axisAcross(const Plane& plane);
/// The side that such a plane keeps; absent for an oblique one.
std::optional<AnatomicalView> keptSide(const Plane& plane);
/// Where a plane stands, in millimetres: along its axis of LPS (positive towards the left, the back
/// and the head), an oblique one along its normal.
double positionOf(const Plane& plane);

/// The planes of the sections, in their order.
std::vector<Plane> planesOf(std::span<const Section> sections);

/// What makes a plane unusable, for an error message.
std::optional<std::string_view> planeFault(const Plane& plane);

}  // namespace sline::model
