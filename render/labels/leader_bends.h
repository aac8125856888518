// SPDX-License-Identifier: Apache-2.0
// Bends the leaders of a column's boxes around each other.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "render/labels/column.h"

namespace sline::render {

/// Tells how a leader is bent between its place and its box. `boxLevel`: it leaves the place aslant
/// and runs level in front of the box, from a point that is nearer to the box the smaller `far` is.
/// `placeLevel`: it leaves the place level and goes aslant after `far` of the way; as long as
/// places have the same order as boxes, such leaders never cross.
struct LeaderBend {
  enum class Way { boxLevel, placeLevel } way = Way::boxLevel;
  float far = 0.0f;  ///< 0 … 1
};
/// The straighter a bend, the earlier it stands.
inline constexpr std::array<LeaderBend, 9> leaderBends{{{LeaderBend::Way::boxLevel, 0.0f},
                                                        {LeaderBend::Way::boxLevel, 0.25f},
                                                        {LeaderBend::Way::placeLevel, 0.25f},
                                                        {LeaderBend::Way::boxLevel, 0.5f},
                                                        {LeaderBend::Way::placeLevel, 0.5f},
                                                        {LeaderBend::Way::boxLevel, 0.75f},
                                                        {LeaderBend::Way::placeLevel, 0.75f},
                                                        {LeaderBend::Way::boxLevel, 1.0f},
                                                        {LeaderBend::Way::placeLevel, 1.0f}}};

/// Returns the leader from the place to the column's box.
Leader leaderOf(const Column& column, const glm::vec2& place, const LabelBox& box,
                const LeaderBend& bend = {});

/// Tells whether the leaders cross, one passes the other's dot, or one runs through the other's
/// box, from a place behind the column.
bool inTheWay(const ColumnPlacement& a, const ColumnPlacement& b);
bool leadersCross(const ColumnPlacement& a, const ColumnPlacement& b);

/// Tells whether two leaders can be bent so that neither disturbs the other; boxes stay.
bool canPass(const Column& column, const ColumnPlacement& a, const ColumnPlacement& b);

/// Returns the first two places for which `stand` is true, neighbours first.
template <typename Stand>
std::optional<std::pair<std::size_t, std::size_t>> firstPair(
    const std::vector<ColumnPlacement>& places, Stand&& stand) {
  for (std::size_t apart = 1; apart < places.size(); ++apart)
    for (std::size_t i = 0; i + apart < places.size(); ++i)
      if (stand(places[i], places[i + apart]))
        return std::pair(i, i + apart);
  return std::nullopt;
}

/// Returns the first two items that are in each other's way.
/// Neighbours come first, as exchanging them moves least.
std::optional<std::pair<std::size_t, std::size_t>> firstCrossing(
    const std::vector<ColumnPlacement>& places);

/// Bends leaders, as few and as little as it finds necessary, until no two cross and none passes
/// another's dot; boxes stay. It returns false, and changes nothing, where that is impossible.
bool bendApart(const Column& column, std::vector<ColumnPlacement>& places);

}  // namespace sline::render
