// SPDX-License-Identifier: Apache-2.0
// Computes sets of nodes for edits.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Holds the ids of nodes, by value.
using NodeSet = std::unordered_set<std::uint64_t>;

NodeSet setOf(std::span<const NodeId> ids);
/// Returns the nodes and all below them.
NodeSet withAllBelow(const Scene& scene, NodeSet ids);
/// Returns the nodes and all groups above them.
NodeSet withAllAbove(const Scene& scene, NodeSet ids);
/// Returns, in tree order, those of the ids that are in the scene and have no other of the ids
/// above them.
std::vector<NodeId> topmost(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
