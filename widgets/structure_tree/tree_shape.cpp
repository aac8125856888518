// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/tree_shape.h"

#include <algorithm>

namespace sline::widgets {

using model::NodeId;
using model::rootId;

TreeShape::TreeShape(const model::Scene& scene, const model::NodeSet* shown) {
  m_places.reserve(scene.nodes().size() + 1);
  m_places[rootId.value] = {};
  for (const model::Node& node : scene.nodes()) {
    if (shown && !shown->contains(node.id.value))
      continue;
    std::vector<NodeId>& siblings = at(node.parent).children;
    const int row = int(siblings.size());
    siblings.push_back(node.id);
    m_places[node.id.value] = {node.parent, row, {}};
  }
}

const TreeShape::Entry* TreeShape::find(NodeId id) const {
  const auto found = m_places.find(id.value);
  return found == m_places.end() ? nullptr : &found->second;
}

bool TreeShape::isBelow(NodeId id, NodeId ancestor) const {
  for (;;) {
    if (id == ancestor)
      return true;
    if (id == rootId)
      return false;
    id = m_places.at(id.value).parent;
  }
}

bool TreeShape::sameAs(const TreeShape& other) const {
  return m_places.size() == other.m_places.size() &&
         std::all_of(m_places.begin(), m_places.end(), [&other](const auto& entry) {
           const Entry* there = other.find(NodeId{entry.first});
           return there && there->children == entry.second.children;
         });
}

void TreeShape::renumber(NodeId parent, int from) {
  const std::vector<NodeId>& children = at(parent).children;
  for (std::size_t row = std::size_t(from); row < children.size(); ++row)
    at(children[row]).row = int(row);
}

void TreeShape::forget(NodeId id) {
  const std::vector<NodeId> children = std::move(at(id).children);
  m_places.erase(id.value);
  for (const NodeId child : children)
    forget(child);
}

void TreeShape::apply(const RowStep& step) {
  const bool comes = step.kind == RowStep::Kind::insert;
  if (!comes) {
    std::vector<NodeId>& children = at(step.parent).children;
    const auto first = children.begin() + step.first;
    children.erase(first, first + std::ptrdiff_t(step.ids.size()));
    renumber(step.parent, step.first);
  }
  if (step.kind == RowStep::Kind::remove) {
    for (const NodeId id : step.ids)
      forget(id);
    return;
  }
  const NodeId parent = comes ? step.parent : step.target;
  const int row = comes ? step.first : step.row;
  for (const NodeId id : step.ids)
    m_places[id.value].parent = parent;
  std::vector<NodeId>& children = at(parent).children;
  children.insert(children.begin() + row, step.ids.begin(), step.ids.end());
  renumber(parent, row);
}

namespace {

/// Returns a longest rising sequence among the positions: those rows may stay while the rest moves.
std::vector<bool> longestRise(const std::vector<int>& positions) {
  std::vector<std::size_t> tails;  // the last of the best sequence of each length
  std::vector<std::size_t> before(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto longer =
        std::lower_bound(tails.begin(), tails.end(), positions[i],
                         [&](std::size_t tail, int value) { return positions[tail] < value; });
    before[i] = longer == tails.begin() ? i : *std::prev(longer);
    if (longer == tails.end())
      tails.push_back(i);
    else
      *longer = i;
  }
  std::vector<bool> rises(positions.size());
  for (std::size_t i = tails.empty() ? 0 : tails.back(), n = tails.size(); n > 0; --n) {
    rises[i] = true;
    i = before[i];
  }
  return rises;
}

/// Computes the steps on a copy of the original tree.
class Difference {
 public:
  Difference(const TreeShape& from, const TreeShape& to, std::size_t most)
      : m_now(from), m_to(to), m_most(most) {}

  std::optional<std::vector<RowStep>> steps() {
    forEachGroup([this](NodeId group) { insertInto(group); });
    forEachGroup([this](NodeId group) { moveInto(group); });
    forEachGroup([this](NodeId group) { removeFrom(group); });
    return m_failed ? std::nullopt : std::optional(std::move(m_steps));
  }

 private:
  template <class Visit>
  void forEachGroup(const Visit& visit) {
    std::vector<NodeId> waiting{rootId};
    while (!waiting.empty() && !m_failed) {
      const NodeId id = waiting.back();
      waiting.pop_back();
      visit(id);
      const std::vector<NodeId>& children = m_to.find(id)->children;
      waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
  }

  void take(RowStep step) {
    m_failed = m_failed || m_steps.size() >= m_most;
    if (m_failed)
      return;
    m_now.apply(step);
    m_steps.push_back(std::move(step));
  }

  void insertInto(NodeId group) {
    const std::vector<NodeId>& wanted = m_to.find(group)->children;
    int row = 0;
    for (std::size_t i = 0; i < wanted.size();) {
      const TreeShape::Entry* there = m_now.find(wanted[i]);
      if (there) {
        if (there->parent == group)
          row = there->row + 1;
        ++i;
        continue;
      }
      RowStep step{.kind = RowStep::Kind::insert, .parent = group, .first = row};
      for (; i < wanted.size() && !m_now.find(wanted[i]); ++i)
        step.ids.push_back(wanted[i]);
      row += int(step.ids.size());
      take(std::move(step));
    }
  }

  void moveInto(NodeId group) {
    const std::vector<NodeId> wanted = m_to.find(group)->children;
    std::vector<int> positions;
    for (const NodeId id : wanted)
      if (m_now.find(id)->parent == group)
        positions.push_back(m_now.find(id)->row);
    const std::vector<bool> rises = longestRise(positions);
    std::vector<bool> stays;
    for (std::size_t i = 0, here = 0; i < wanted.size(); ++i)
      stays.push_back(m_now.find(wanted[i])->parent == group && rises[here++]);
    for (std::size_t i = 0; i < wanted.size() && !m_failed;) {
      if (stays[i]) {
        ++i;
        continue;
      }
      const TreeShape::Entry from = *m_now.find(wanted[i]);
      RowStep step{
          .kind = RowStep::Kind::move, .parent = from.parent, .first = from.row, .target = group};
      const NodeId before = i == 0 ? rootId : wanted[i - 1];
      for (; i < wanted.size() && !stays[i]; ++i) {
        const TreeShape::Entry& next = *m_now.find(wanted[i]);
        if (next.parent != from.parent || next.row != from.row + int(step.ids.size()))
          break;
        m_failed = m_failed || m_now.isBelow(group, wanted[i]);
        step.ids.push_back(wanted[i]);
      }
      step.row = before == rootId ? 0 : m_now.find(before)->row + 1;
      if (from.parent == group && from.row < step.row)
        step.row -= int(step.ids.size());
      const bool there = from.parent == group && from.row == step.row;
      if (!there)
        take(std::move(step));
    }
  }

  void removeFrom(NodeId group) {
    for (int row = int(m_now.find(group)->children.size()) - 1; row >= 0; --row) {
      const std::vector<NodeId>& there = m_now.find(group)->children;
      if (m_to.find(there[std::size_t(row)]))
        continue;
      int first = row;
      while (first > 0 && !m_to.find(there[std::size_t(first - 1)]))
        --first;
      take({.kind = RowStep::Kind::remove,
            .parent = group,
            .first = first,
            .ids = {there.begin() + first, there.begin() + row + 1}});
      if (m_failed)
        return;
      row = first;
    }
  }

  TreeShape m_now;
  const TreeShape& m_to;
  std::size_t m_most;
  std::vector<RowStep> m_steps;
  bool m_failed = false;
};

}  // namespace

std::optional<std::vector<RowStep>> stepsBetween(const TreeShape& from, const TreeShape& to,
                                                 std::size_t most) {
  return Difference(from, to, most).steps();
}

}  // namespace sline::widgets
