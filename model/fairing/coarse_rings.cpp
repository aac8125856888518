// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/coarse_rings.h"

#include <algorithm>
#include <utility>

namespace sline::model {

namespace {
constexpr std::uint32_t noGroup = 0xffffffffu;

std::size_t countOf(std::span<const std::uint32_t> groups) {
  return groups.empty() ? 0 : std::size_t(*std::max_element(groups.begin(), groups.end())) + 1;
}
}  // namespace

CoarseRings::CoarseRings(const VertexRings& fine)
    : m_groups(groupsOf(fine)), m_rings(ringsOf(fine, m_groups)) {}

std::vector<std::uint32_t> CoarseRings::groupsOf(const VertexRings& fine) {
  std::vector<std::uint32_t> groups(fine.vertexCount(), noGroup);
  std::uint32_t count = 0;
  const auto isFree = [&groups](std::uint32_t v) { return groups[v] == noGroup; };
  for (std::uint32_t v = 0; v < groups.size(); ++v) {
    const auto ring = fine[v];
    if (!isFree(v) || !std::all_of(ring.begin(), ring.end(), isFree))
      continue;
    groups[v] = count;
    for (const std::uint32_t other : ring)
      groups[other] = count;
    ++count;
  }
  // What is left lies beside a group, or it would have become one.
  const std::vector<std::uint32_t> whole = groups;
  for (std::uint32_t v = 0; v < groups.size(); ++v)
    for (const std::uint32_t other : fine[v])
      if (isFree(v) && whole[other] != noGroup)
        groups[v] = whole[other];
  return groups;
}

VertexRings CoarseRings::ringsOf(const VertexRings& fine, std::span<const std::uint32_t> groups) {
  const std::size_t count = countOf(groups);
  std::vector<std::uint32_t> firstMember(count + 1, 0);
  for (const std::uint32_t group : groups)
    ++firstMember[group + 1];
  for (std::size_t group = 1; group <= count; ++group)
    firstMember[group] += firstMember[group - 1];
  std::vector<std::uint32_t> members(groups.size());
  std::vector<std::uint32_t> next(firstMember.begin(), firstMember.end() - 1);
  for (std::uint32_t v = 0; v < groups.size(); ++v)
    members[next[groups[v]]++] = v;

  std::vector<std::uint32_t> first{0};
  first.reserve(count + 1);
  std::vector<std::uint32_t> neighbours;
  neighbours.reserve(8 * count);
  std::vector<char> border(count, 0);
  std::vector<std::uint32_t> metBy(count, noGroup);
  for (std::uint32_t group = 0; group < count; ++group) {
    for (std::uint32_t i = firstMember[group]; i < firstMember[group + 1]; ++i) {
      border[group] = char(border[group] != 0 || fine.onBorder(members[i]));
      for (const std::uint32_t other : fine[members[i]])
        if (const std::uint32_t beside = groups[other];
            beside != group && std::exchange(metBy[beside], group) != group)
          neighbours.push_back(beside);
    }
    first.push_back(std::uint32_t(neighbours.size()));
  }
  return {std::move(first), std::move(neighbours), std::move(border)};
}

}  // namespace sline::model
