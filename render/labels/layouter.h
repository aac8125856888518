// SPDX-License-Identifier: Apache-2.0
// Lays out the labels of one request. Labels choose their posts (layouter.cpp) and are given places
// there (label_places.cpp), until none is in conflict with another. What anatomy leaves no room in
// a column may have some at the picture's edge (edge_places.cpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/labels/column.h"
#include "render/labels/label_room.h"

namespace sline::render {

/// Tracks an item in this layout.
struct Fate {
  LabelPost post = LabelPost::left;
  bool tried = false;  ///< has also tried the other side
  bool out = false;
};

class Layouter {
 public:
  /// `home`, if given, is where all labels would stand if none had been moved by hand.
  Layouter(const LabelRequest& request, const LabelLayout* before,
           const LabelLayout* home = nullptr)
      : m_request(request),
        m_before(before),
        m_home(home),
        m_frame(frameOf(request.space)),
        m_fates(request.items.size()),
        m_placed(request.items.size()) {
    setRanks();
  }

  LabelLayout layOut();
  /// Returns what `labelConflicts` returns.
  std::vector<std::pair<std::size_t, std::size_t>> conflicts();

 private:
  const LabelItem& item(std::size_t i) const { return m_request.items[i]; }
  const PlacedLabel* before(std::size_t i) const {
    return m_before ? m_before->find(item(i).id) : nullptr;
  }
  const PlacedLabel* home(std::size_t i) const {
    return m_home ? m_home->find(item(i).id) : nullptr;
  }
  /// Returns where it stays if it can: at home, or else where it was before.
  const PlacedLabel* stands(std::size_t i) const {
    const PlacedLabel* home = this->home(i);
    return home && home->post == m_fates[i].post ? home : before(i);
  }
  Column column(LabelPost post) const;

  void setRanks();
  void setColumns();
  /// Makes room for the widest box in each column. While layouts follow each other, columns only
  /// grow, and at once far enough to need no further growth.
  void widen();
  /// Takes back the room of boxes that have left a column; tells whether there was some.
  bool narrow();
  /// Finds where the columns would lie over what is drawn, if they must not.
  void findDrawn();
  /// Tells whether the layout follows others, of which it keeps what it can.
  bool follows() const { return m_request.moving || (m_before && !m_before->labels.empty()); }
  /// Returns between which x the column on that side stands.
  Span acrossColumn(std::size_t side) const;
  /// Returns the heights of a column that are taken by things that do not give way, or by its
  /// labels' dots.
  std::vector<Span> blockedIn(LabelPost post) const;
  bool fit(LabelPost post) const { return fitIn(column(post), inColumn(post)); }
  /// Returns how many degrees the camera has turned since the label last jumped.
  float calm(std::size_t i) const;
  /// Returns where the camera was at the last jump; zero for a label that has not jumped.
  glm::vec3 lastJump(std::size_t i) const;
  /// Tells whether the label may not jump in this layout.
  bool rests(std::size_t i) const { return m_request.moving && calm(i) <= restDegrees; }
  /// Tells whether the box is wider than half of the frame, which is each column's share. One label
  /// takes more only where no narrower one stands.
  bool tooWide(std::size_t i) const { return item(i).box.x > 0.5f * m_frame.size().x; }
  /// Places all items, and lets those give way that are in conflict, until none is.
  void settle();
  /// Lets those that gave way come back on the sides that were chosen for them, where that has
  /// become possible, also with leaders that bend round others.
  void comeBack(const std::vector<Fate>& chosen);
  /// Lets labels in that anatomy leaves no room in their columns: each by itself stands at the
  /// picture's edge where it lies over nothing that is drawn.
  void fillEdges();
  bool placeAtEdge(std::size_t i, LabelPost post);
  /// Tells whether the label is in conflict with no other and stands where it may.
  bool standsClear(std::size_t i) const;
  void choosePosts();
  /// Lets a label that is too wide into a column where nothing else stands.
  void letWideIn();
  LabelPost sideOf(std::size_t i) const;
  /// Tells whether the item has room in the other column.
  bool fitsAcross(std::size_t i);
  /// Moves the items nearest to the middle to the other side, as long as that has room, then the
  /// least important ones out, until the column's boxes fit in.
  void relieve(LabelPost post);
  std::vector<ColumnItem> inColumn(LabelPost post) const;
  float wantedHeight(std::size_t i) const;
  void place();
  void placeByHand(std::size_t i);
  Leader leaderToHand(const LabelBox& box, const glm::vec2& place) const;
  /// Tells whether part of the box is outside the frame or where something is reserved, or whether
  /// it covers what it points at.
  bool misplaced(std::size_t i) const;
  void placeColumn(LabelPost post);
  /// Places the labels of a film's picture.
  void placeAtHeights(LabelPost post);
  /// Places items so that those that were there before stay, except for those that must move;
  /// returns false where that fails.
  bool placeSteadily(LabelPost post, const std::vector<ColumnItem>& items);
  void put(const ColumnItem& one, LabelPost post, const ColumnPlacement& place);
  void placeBeside(std::size_t i);
  /// Bends leaders so that fewer meet, those to labels moved by hand if others cannot go past them.
  void bendApart();
  void bend(std::size_t i, const std::vector<Leader>& ways);
  /// In a film bends leaders of columns as they were bent before, or else so that fewer meet.
  void bendSteadily();
  void setBend(std::size_t i, const Column& column, std::size_t bend);
  /// Bends one after the other as long as fewer meet; returns how many do.
  std::size_t unravel(const std::array<Column, 2>& columns);
  void bendRound(std::size_t hand);
  std::vector<Leader> waysRoundHand(std::size_t i, std::size_t hand) const;
  std::vector<Leader> bestWaysOf(std::size_t i);
  std::size_t conflictsOf(std::size_t i) const;
  /// Returns leaders that the label may have, beginning with its own.
  std::vector<Leader> waysOf(std::size_t i) const;
  bool fits(std::size_t i, const LabelBox& box) const;
  std::optional<std::size_t> firstLoser() const;
  bool inConflict(std::size_t i, std::size_t j) const;
  std::size_t loserOf(std::size_t i, std::size_t j) const;
  void giveWay(std::size_t i);
  LabelLayout answer() const;

  const LabelRequest& m_request;
  const LabelLayout* m_before;
  const LabelLayout* m_home;
  LabelBox m_frame;
  std::array<float, 2> m_near{};  ///< the edges of columns that have room there
  std::array<float, 2> m_edges{};
  std::array<float, 2> m_widths{};
  std::array<Span, 2> m_across{};                ///< between which x columns were when it was found
  std::array<std::vector<Span>, 2> m_overDrawn;  ///< at which heights they lie over what is drawn
  bool m_bending = false;  ///< leaders of columns are bent, so that left out labels find room
  bool m_crowded = false;  ///< more than fit: none goes across for the sake of another
  float m_middle = 0.0f;
  float m_width = 0.0f;              ///< that of the anatomy
  std::vector<std::size_t> m_wide;   ///< those that wait for a column without narrower labels
  std::vector<std::size_t> m_order;  ///< the items, the most important first
  std::vector<std::size_t> m_ranks;  ///< of the items in it
  std::vector<Fate> m_fates;
  std::vector<std::optional<PlacedLabel>> m_placed;
};

}  // namespace sline::render
