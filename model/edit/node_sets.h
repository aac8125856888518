// SPDX-License-Identifier: Apache-2.0
// Sets of nodes, as edits need them.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Ids of nodes, by value.
using NodeSet = std::unordered_set<std::uint64_t>;

NodeSet setOf(std::span<const NodeId> ids);
/// The nodes and all below them.
NodeSet withAllBelow(const Scene& scene, NodeSet ids);
/// The nodes and all groups above them.
NodeSet withAllAbove(const Scene& scene, NodeSet ids);
/// Those of the ids that the scene has and above which no other of them stands, in tree order.
std::vector<NodeId> topmost(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
