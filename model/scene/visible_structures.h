// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "model/camera/free_sides.h"
#include "model/scene/scene.h"

namespace sline::model {

struct VisibleStructure {
  const Node* node = nullptr;  ///< a node of the scene that was passed in
  ResolvedStyle style;
};

/// Returns the visible structures in tree order, in one pass: those that have triangles and are
/// hidden neither by their own style nor by a group.
std::vector<VisibleStructure> visibleStructures(const Scene& scene);

/// Tells whether sections take away all of the structure.
bool isCutAway(const Scene& scene, const Node& structure);

/// Returns the ids, by value, of the structures that visible annotations point at.
std::unordered_set<std::uint64_t> annotatedStructures(const Scene& scene);

inline constexpr std::array<NodeId, 1> everything{rootId};

/// Returns the points of the visible structures at or below the nodes that no section takes away,
/// and those where sections cut edges; LPS, millimetres.
std::vector<glm::vec3> visiblePoints(const Scene& scene,
                                     std::span<const NodeId> within = everything);

/// Returns the camera, not turned, fitted to the visible points themselves, because a slanted
/// structure leaves much of its box empty. Where nothing is visible it stays as it was.
Camera fittedToVisible(const Scene& scene, const Camera& camera, float aspect,
                       const FreeSides& sides = {}, std::span<const NodeId> within = everything);

/// Returns the perspective camera that shows all that is visible from that side: the one view of
/// that name, in a window and in files.
Camera fittedView(const Scene& scene, AnatomicalView view, float aspect,
                  const FreeSides& sides = {});

}  // namespace sline::model
