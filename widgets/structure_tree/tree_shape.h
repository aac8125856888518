// SPDX-License-Identifier: Apache-2.0
// Holds which rows stand where, and computes the steps that lead from one tree to another: rows
// that stay keep their expansion and their place on screen.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "model/edit/node_sets.h"

namespace sline::widgets {

/// A step in which some neighbouring rows come, go with all below them, or move.
struct RowStep {
  enum class Kind { insert, move, remove };
  Kind kind = Kind::insert;
  model::NodeId parent;
  int first = 0;
  std::vector<model::NodeId> ids;
  model::NodeId target;  ///< of a move: the parent there
  int row = 0;           ///< of a move: the first row there, counted once the rows have left
};

class TreeShape {
 public:
  struct Entry {
    model::NodeId parent;
    int row = 0;
    std::vector<model::NodeId> children;
  };

  /// Makes the shape of all nodes, or of those to be shown, which include the groups above each.
  explicit TreeShape(const model::Scene& scene, const model::NodeSet* shown = nullptr);
  /// Returns the node's place, null for a node without a row; the root has a place of its own.
  const Entry* find(model::NodeId id) const;
  std::size_t rows() const { return m_places.size() - 1; }
  bool isBelow(model::NodeId id, model::NodeId ancestor) const;
  bool sameAs(const TreeShape& other) const;

  void apply(const RowStep& step);

 private:
  Entry& at(model::NodeId id) { return m_places.at(id.value); }
  void renumber(model::NodeId parent, int from);
  void forget(model::NodeId id);

  std::unordered_map<std::uint64_t, Entry> m_places;
};

/// Returns the steps; none where more than `most` would be needed, or a group came to stand below
/// itself.
std::optional<std::vector<RowStep>> stepsBetween(const TreeShape& from, const TreeShape& to,
                                                 std::size_t most);

}  // namespace sline::widgets
