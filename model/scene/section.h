// SPDX-License-Identifier: Apache-2.0
// Defines section planes, which cut parts of the scene away so that its inside can be seen.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/plane.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// Names a section for as long as the scene lives, through every edit and through undo.
struct SectionId {
  std::uint64_t value = 0;
  auto operator<=>(const SectionId&) const = default;
};

/// How cut faces are drawn: as white as the paper, in a tint of the structure's colour, or with the
/// pattern of its tissue on that tint, as printed atlases have them.
enum class CutFaces : std::uint8_t { off, tint, tissue };

/// The names of these looks in scene files and on the command line, in the order of the values.
inline constexpr std::array<std::string_view, 3> cutFacesNames{"off", "tint", "tissue"};
/// Returns the look of that name.
std::optional<CutFaces> cutFacesNamed(std::string_view name);

/// A section cuts every structure at or below `scope`. Solids (see Surface) get a cut face in their
/// colour with an inked outline; sheets are cut open.
struct Section {
  SectionId id;
  std::string name;
  Plane plane;
  NodeId scope = rootId;
  bool enabled = true;
  CutFaces faces = CutFaces::tissue;
  bool hatched = false;  ///< whether cut faces without a pattern have strokes at 45°
  std::string unread;    ///< like Node::unread
  bool operator==(const Section&) const = default;
};

/// The number of sections that may cut one structure.
inline constexpr std::size_t maximumSections = 8;

/// Returns the anatomical plane that keeps the given side: sagittal for left and right, coronal for
/// anterior and posterior, axial for superior and inferior. `mm` is the plane's place along x, y or
/// z of LPS.
Plane anatomicalPlane(AnatomicalView kept, float mm);
/// Returns the axis of LPS across which the side's plane stands: 0 for sagittal, 1 for coronal and
/// 2 for axial.
int axisOf(AnatomicalView side);

/// Returns 0, 1 or 2 where the plane stands across the x, y or z axis of LPS; absent for an oblique
/// plane.
std::optional<int> axisAcross(const Plane& plane);
/// Returns the side that an anatomical plane keeps; absent for an oblique plane.
std::optional<AnatomicalView> keptSide(const Plane& plane);
/// Returns where a plane stands, in millimetres: along its axis of LPS (positive towards the left,
/// the back and the head), for an oblique plane along its normal.
double positionOf(const Plane& plane);

/// Returns the planes of the sections, in their order.
std::vector<Plane> planesOf(std::span<const Section> sections);

/// Returns what makes a plane unusable, for an error message.
std::optional<std::string_view> planeFault(const Plane& plane);

}  // namespace sline::model
