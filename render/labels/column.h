// SPDX-License-Identifier: Apache-2.0
// One column of boxes beside the picture's anatomy, each joined to its place by a straight leader
// that ends in a short level piece – or a leader bent so that its box can stay where it is, or,
// from a place behind the column, one that ends at the nearest side of its box: one-sided boundary
// labelling with type-s leaders (Bekos, Kaufmann, Symvonis and Wolff: Boundary labeling: models and
// efficient algorithms for rectangular maps. Computational Geometry 36, 2007).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/labels/shapes.h"

namespace sline::render {

/// Millimetres between boxes, and of a leader's level piece.
inline constexpr float columnGap = 0.8f;
inline constexpr float levelPiece = 2.0f;
/// Between a leader and another's box.
inline constexpr float clearance = 0.4f;
/// Between the middle of a dot and a box.
inline constexpr float dotRoom = 1.2f;

/// A box that has jumped stays where it is for so long, where others can give way.
inline constexpr float restDegrees = 20.0f;

/// Anywhere in the column.
inline constexpr float columnReach = 1e6f;

struct ColumnItem {
  std::size_t item = 0;  ///< whose it is, for whoever asks
  glm::vec2 place{0.0f};
  glm::vec2 box{0.0f};  ///< width and height
  float calm = 360.0f;  ///< degrees that the camera has turned since its box last jumped
  float wanted = 0.0f;  ///< height of the box's middle; of its place, or not far from it
};

/// Heights from `low` down to `high`.
struct Span {
  float low = 0.0f;
  float high = 0.0f;
  float length() const { return high - low; }
};

struct Column {
  bool left = true;   ///< of the anatomy: boxes end at `edge`; else they begin there
  float edge = 0.0f;  ///< x of the boxes' sides that face the anatomy
  float top = 0.0f;
  float bottom = 0.0f;
  float gap = columnGap;      ///< between boxes, at least
  std::vector<Span> blocked;  ///< where no box stands, in any order
};

/// What is left of the column between what is blocked, from the top; never empty: where all is
/// blocked, one span without length.
std::vector<Span> freeSpans(const Column& column);
/// In that order the items find room in what is free.
bool fitIn(const Column& column, const std::vector<ColumnItem>& items);

struct ColumnPlace {
  LabelBox box;
  Leader leader;
};

/// How high, with those gaps, the items stand one above the other.
float heightOf(const std::vector<ColumnItem>& items, float gap = columnGap);

/// Boxes in the order of the items from the top, each as near its wanted height as the others
/// let it: in each free span the sum of squares is the least (by pooling adjacent violators). They
/// must fit.
std::vector<ColumnPlace> placesIn(const Column& column, const std::vector<ColumnItem>& items);

/// Two whose leaders cross, or of which one's leader runs through the other's box, neighbours
/// first: their exchange moves least.
std::optional<std::pair<std::size_t, std::size_t>> firstCrossing(
    const std::vector<ColumnPlace>& places);

/// Bends leaders, as few and as little as are found to be needed, until no two cross; boxes stay.
/// False, and nothing changes, where that cannot be.
bool bendApart(const Column& column, std::vector<ColumnPlace>& places);

/// Exchanges items until no two leaders cross, as few as are found to be needed. An exchange of two
/// that cross makes leaders shorter, so that it comes to an end (Bekos et al., lemma on type-s
/// leaders); boxes of different heights may leave crossings all the same.
void uncross(const Column& column, std::vector<ColumnItem>& items);

/// Where a further box finds room beside those that stay, nearest to its wanted height, its leader
/// crossing none of theirs; nothing where there is no such place within `reach` of it.
std::optional<ColumnPlace> placeAmong(const Column& column, const ColumnItem& item,
                                      const std::vector<ColumnPlace>& others, float reach);

/// `gentle`: so that none of the others jumps.
enum class Push { gentle, any };

/// Puts the item between the others where they have to move least for it, no leaders crossing;
/// false, and nothing changes but what they want, where that cannot be.
bool pushIn(const Column& column, const ColumnItem& item, std::vector<ColumnItem>& items,
            std::vector<ColumnPlace>& places, Push push);

/// Without that one of the others there would be a place for the item.
bool makesWay(const Column& column, const ColumnItem& item, std::vector<ColumnItem> others,
              std::size_t without);

}  // namespace sline::render
