// SPDX-License-Identifier: Apache-2.0
// Computes the room that labels have in the output's plane.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/labels/column.h"
#include "render/labels/layout.h"

namespace sline::render {

/// The space between boxes and the output's edge, millimetres.
inline constexpr float edgePadding = 2.0f;
/// The space between a column and the anatomy.
inline constexpr float anatomyGap = 5.0f;
/// Tells whether the box covers the item's own dot, or the line that it measures.
bool coversOwn(const LabelItem& item, const LabelBox& box);
/// Tells whether the item stands beside its place, where there is room.
bool standsBeside(const LabelItem& item);
bool isColumn(LabelPost post);
/// Returns the opposite post of a column.
LabelPost otherSide(LabelPost post);
/// Tells whether a label jumps: to another post, or with its box more than 2 mm up or down.
bool jumps(const PlacedLabel& was, const PlacedLabel& is);
/// Returns what the item points at; for a distance, the middle.
glm::vec2 placeOf(const LabelItem& item);
/// Returns the x that decides between the columns: items with a place to the left of it have their
/// label in the left one. It is the middle of the anatomy, so that what lies on one side of the
/// patient is labelled there; what lies in the middle itself goes where fewer are.
float middleBetweenColumns(const std::vector<LabelItem>& items, const LabelBox& anatomy);
/// Returns the area in which boxes may stand.
LabelBox frameOf(const LabelSpace& space);
/// Returns the edges of the left and the right column where there is room beside the anatomy.
std::array<float, 2> edgesBeside(const LabelBox& anatomy);
/// Returns the edges that columns of those widths have: those, or as near as the frame allows.
std::array<float, 2> edgesOf(const std::array<float, 2>& beside, const LabelBox& frame,
                             const std::array<float, 2>& widths);
/// Tells whether there is room in the frame for a box of that size.
bool hasRoom(const LabelBox& frame, const glm::vec2& box);
/// Tells whether the box is within the frame, apart from rounding.
bool within(const LabelBox& box, const LabelBox& frame);
/// Tells whether text in the box would lie over what is drawn.
bool liesOver(const SeenArea& drawn, const LabelBox& box);
/// Returns the heights at which text between those two x would lie over what is drawn, from the
/// top.
std::vector<Span> heightsOver(const SeenArea& drawn, const Span& across);
bool overlapAny(const LabelBox& box, const std::vector<LabelBox>& others);
/// Returns the nearest place for the box within the frame where nothing is reserved; the box
/// unchanged where no such place is found beside the areas that it covers.
LabelBox besideReserved(const LabelBox& box, const LabelBox& frame,
                        const std::vector<LabelBox>& reserved);
/// Returns the heights that the leader has between those two x.
std::optional<Span> heightsWithin(const Leader& leader, float low, float high);
/// Returns the leader from the place to the box's side, where `portOf` puts its end; empty where
/// the box covers the place.
Leader leaderTo(const LabelBox& box, const glm::vec2& place);

}  // namespace sline::render
