// SPDX-License-Identifier: Apache-2.0
// The room that labels have in the output's plane.
#pragma once

#include <optional>

#include "render/labels/column.h"
#include "render/labels/layout.h"

namespace sline::render {

/// Millimetres between boxes and the output's edge.
inline constexpr float edgePadding = 2.0f;
/// Between a column and the anatomy.
inline constexpr float anatomyGap = 5.0f;
/// The box covers the item's own dot, or the line that it measures.
bool coversOwn(const LabelItem& item, const LabelBox& box);
/// Beside its place, where there is room.
bool standsBeside(const LabelItem& item);
bool isColumn(LabelPost post);
/// Of a column.
LabelPost otherSide(LabelPost post);
/// To another post, or its box more than 2 mm up or down.
bool jumps(const PlacedLabel& was, const PlacedLabel& is);
/// What the item points at; of a distance the middle.
glm::vec2 placeOf(const LabelItem& item);
/// Whose place lies to the left of that x has its label in the left column: between the middle of
/// the anatomy and that of the places, so that neither column is crowded.
float middleBetweenColumns(const std::vector<LabelItem>& items, float anatomyMiddle);
/// Where boxes may stand.
LabelBox frameOf(const LabelSpace& space);
/// There is room in the frame for a box of that size.
bool hasRoom(const LabelBox& frame, const glm::vec2& box);
/// No more than rounding lies outside.
bool within(const LabelBox& box, const LabelBox& frame);
bool overlapAny(const LabelBox& box, const std::vector<LabelBox>& others);
/// The nearest place for the box within the frame where nothing is reserved; as it is where none is
/// found beside what it covers.
LabelBox besideReserved(const LabelBox& box, const LabelBox& frame,
                        const std::vector<LabelBox>& reserved);
/// The heights at which the leader is between those two x.
std::optional<Span> heightsWithin(const Leader& leader, float low, float high);
/// From the place to the box's side, where `portOf` says; empty where the box covers the place.
Leader leaderTo(const LabelBox& box, const glm::vec2& place);

}  // namespace sline::render
