// SPDX-License-Identifier: Apache-2.0
#include "render/labels/leader_bends.h"

#include <algorithm>

namespace sline::render {

namespace {

/// Returns the leader of that place with that bend.
Leader bent(const Column& column, const ColumnPlacement& place, const LeaderBend& bend) {
  return leaderOf(column, place.leader.front(), place.box, bend);
}

/// Returns in how many ways that leader can be bent. Straight ones, from behind the column or close
/// in front of it, never are.
std::size_t waysOf(const ColumnPlacement& place) {
  return place.leader.size() > 2 ? leaderBends.size() : 1;
}

/// Bends either of two leaders that disturb each other, so that they disturb neither each other nor
/// any other.
bool bendPair(const Column& column, std::vector<ColumnPlacement>& places, std::size_t i,
              std::size_t j) {
  const auto free = [&](const Leader& leader, std::size_t self, std::size_t other) {
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != self && k != other && disturb(leader, places[k].leader))
        return false;
    return true;
  };
  std::optional<std::pair<std::size_t, std::size_t>> best;
  for (std::size_t one = 0; one < waysOf(places[i]); ++one)
    for (std::size_t two = 0; two < waysOf(places[j]); ++two) {
      if (best && one + two >= best->first + best->second)
        break;
      const Leader first = bent(column, places[i], leaderBends[one]);
      const Leader second = bent(column, places[j], leaderBends[two]);
      if (!disturb(first, second) && free(first, i, j) && free(second, j, i))
        best = {one, two};
    }
  if (!best)
    return false;
  places[i].leader = bent(column, places[i], leaderBends[best->first]);
  places[j].leader = bent(column, places[j], leaderBends[best->second]);
  return true;
}

}  // namespace

Leader leaderOf(const Column& column, const glm::vec2& place, const LabelBox& box,
                const LeaderBend& bend) {
  const float height = box.middle().y;
  const float inwards = column.left ? 1.0f : -1.0f;
  const float knee = column.edge + inwards * levelPiece;
  if (inwards * (place.x - column.edge) <= dotRoom)
    return {place, portOf(box, place)};
  // From a place beside the knee the leader would turn back at an acute angle.
  if (inwards * (place.x - knee) <= 0.0f)
    return {place, {column.edge, height}};
  if (bend.way == LeaderBend::Way::boxLevel)
    return {place, {knee + bend.far * (place.x - knee), height}, {column.edge, height}};
  constexpr float channel = 3.0f;
  const float last = inwards * std::min(inwards * place.x, inwards * knee + channel);
  return {place,
          {place.x + bend.far * (last - place.x), place.y},
          {knee, height},
          {column.edge, height}};
}

bool inTheWay(const ColumnPlacement& a, const ColumnPlacement& b) {
  const auto through = [](const ColumnPlacement& one, const ColumnPlacement& other) {
    return one.leader.size() == 2 && runsThrough(one.leader, other.box.grown(clearance));
  };
  return disturb(a.leader, b.leader) || through(a, b) || through(b, a);
}

bool canPass(const Column& column, const ColumnPlacement& a, const ColumnPlacement& b) {
  if (!disturb(a.leader, b.leader))
    return true;
  for (std::size_t one = 0; one < waysOf(a); ++one)
    for (std::size_t two = 0; two < waysOf(b); ++two)
      if (!disturb(bent(column, a, leaderBends[one]), bent(column, b, leaderBends[two])))
        return true;
  return false;
}

bool leadersCross(const ColumnPlacement& a, const ColumnPlacement& b) {
  return cross(a.leader, b.leader);
}

std::optional<std::pair<std::size_t, std::size_t>> firstCrossing(
    const std::vector<ColumnPlacement>& places) {
  return firstPair(places, inTheWay);
}

bool bendApart(const Column& column, std::vector<ColumnPlacement>& places) {
  std::vector<ColumnPlacement> tried = places;
  for (std::size_t rounds = 0; rounds <= tried.size(); ++rounds) {
    const auto crossing = firstCrossing(tried);
    if (!crossing) {
      places = std::move(tried);
      return true;
    }
    if (!bendPair(column, tried, crossing->first, crossing->second))
      return false;
  }
  return false;
}

}  // namespace sline::render
