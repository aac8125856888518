// SPDX-License-Identifier: Apache-2.0
// Lays out one column of boxes beside the picture's anatomy. Each box is joined to its place by a
// straight leader that ends in a short level piece, by a leader bent so that its box can stay where
// it is or, from a place behind the column, by one that ends at the nearest side of its box:
// one-sided boundary labelling with type-s leaders (Bekos, Kaufmann, Symvonis and Wolff: Boundary
// labeling: models and efficient algorithms for rectangular maps. Computational Geometry 36, 2007).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/labels/seen/shapes.h"

namespace sline::render {

/// The space between boxes and the length of a leader's level piece, in millimetres.
inline constexpr float columnGap = 0.8f;
inline constexpr float levelPiece = 2.0f;
/// The space between a leader and the box of another label.
inline constexpr float clearance = 0.4f;
/// The space between the middle of a dot and a box.
inline constexpr float dotRoom = 1.2f;

/// A box that has jumped stays where it is for this turn of the camera, where others can give way.
inline constexpr float restDegrees = 20.0f;

/// A reach that covers the whole column.
inline constexpr float columnReach = 1e6f;

struct ColumnItem {
  std::size_t item = 0;  ///< the caller's index of the item
  glm::vec2 place{0.0f};
  glm::vec2 box{0.0f};  ///< width and height
  float calm = 360.0f;  ///< degrees that the camera has turned since its box last jumped
  float wanted = 0.0f;  ///< height of the box's middle: that of its place, or not far from it
};

/// Heights from `low` down to `high`.
struct Span {
  float low = 0.0f;
  float high = 0.0f;
  float length() const { return high - low; }
  bool operator==(const Span&) const = default;
};

struct Column {
  bool left = true;   ///< left of the anatomy: boxes end at `edge`; otherwise they begin there
  float edge = 0.0f;  ///< x of the boxes' sides that face the anatomy
  float top = 0.0f;
  float bottom = 0.0f;
  float gap = columnGap;      ///< the least space between boxes
  std::vector<Span> blocked;  ///< heights where no box stands, in any order
};

/// Returns the parts of the column that are not blocked, from the top. The result is never empty:
/// where everything is blocked, it is one span without length.
std::vector<Span> freeSpans(const Column& column);
/// Tells whether the items, in that order, find room in the free spans.
bool fitIn(const Column& column, const std::vector<ColumnItem>& items);

struct ColumnPlacement {
  LabelBox box;
  Leader leader;
};

/// Returns the height of the items one above the other, with those gaps.
float heightOf(std::span<const ColumnItem> items, float gap = columnGap);

/// Places boxes in the order of the items from the top, each as near its wanted height as the
/// others allow: in each free span the sum of squares is the least (by pooling adjacent violators).
/// They must fit.
std::vector<ColumnPlacement> placesIn(const Column& column, const std::vector<ColumnItem>& items);

/// Exchanges items until no two leaders cross, as few as it finds necessary. Exchanging two that
/// cross makes leaders shorter, so that it comes to an end (Bekos et al., lemma on type-s leaders);
/// boxes of different heights may still leave crossings. Where none does, it exchanges those whose
/// leaders can pass each other's dots in no way else.
void uncross(const Column& column, std::vector<ColumnItem>& items);

/// Returns where a further box finds room beside those that stay, nearest to its wanted height,
/// with a leader that crosses none of theirs; nothing where there is no such place within `reach`
/// of it.
std::optional<ColumnPlacement> placeAmong(const Column& column, const ColumnItem& item,
                                          const std::vector<ColumnPlacement>& others, float reach);

/// Tells how others may be pushed; `gentle`: so that none of them jumps.
enum class Push { gentle, any };

/// Puts the item between the others where they have to move least for it, without crossing leaders.
/// Where that is impossible it returns false and changes nothing but the wanted heights.
bool pushIn(const Column& column, const ColumnItem& item, std::vector<ColumnItem>& items,
            std::vector<ColumnPlacement>& places, Push push);

/// Tells whether there would be a place for the item without that one of the others.
bool makesWay(const Column& column, const ColumnItem& item, std::vector<ColumnItem> others,
              std::size_t without);

}  // namespace sline::render
