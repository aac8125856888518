// SPDX-License-Identifier: Apache-2.0
// Finds places at the picture's edges for labels that anatomy leaves no room in their columns.
#include <algorithm>
#include <cmath>

#include "render/labels/layouter.h"
#include "render/labels/leader_bends.h"

namespace sline::render {

void Layouter::fillEdges() {
  // Columns that no anatomy reaches into have no more room at the edge.
  if (m_overDrawn[0].empty() && m_overDrawn[1].empty())
    return;
  for (const bool hidden : {false, true})
    for (const std::size_t i : m_order) {
      const LabelItem& one = item(i);
      if (!m_fates[i].out || one.hidden != hidden || one.absent || one.places.empty() ||
          standsBeside(one) || one.offset || !hasRoom(m_frame, one.box) || !(one.box.x > 0.0f) ||
          !(one.box.y > 0.0f))
        continue;
      const LabelPost own = sideOf(i);
      m_fates[i].out = false;
      m_fates[i].out = !placeAtEdge(i, own) && (one.side || !placeAtEdge(i, otherSide(own)));
    }
}

bool Layouter::standsClear(std::size_t i) const {
  for (std::size_t k = 0; k < m_placed.size(); ++k)
    if (k != i && m_placed[k] && inConflict(i, k))
      return false;
  return !misplaced(i);
}

bool Layouter::placeAtEdge(std::size_t i, LabelPost post) {
  constexpr float step = 1.5f;
  constexpr std::size_t bendStep = 2;  // of neighbours one is enough
  const LabelItem& one = item(i);
  const bool left = post == LabelPost::left;
  const float low = left ? m_frame.low.x : m_frame.high.x - one.box.x;
  const Column column{.left = left,
                      .edge = left ? low + one.box.x : low,
                      .top = m_frame.low.y,
                      .bottom = m_frame.high.y,
                      .gap = columnGap,
                      .blocked = {}};
  const float wanted =
      std::clamp(placeOf(one).y - 0.5f * one.box.y, m_frame.low.y, m_frame.high.y - one.box.y);
  m_fates[i].post = post;
  const int most = int(std::ceil(m_frame.size().y / step));
  for (int k = 0; k <= 2 * most; ++k) {
    const int away = (k + 1) / 2;
    const float top = wanted + float(k % 2 == 0 ? away : -away) * step;
    const LabelBox box{{low, top}, glm::vec2(low, top) + one.box};
    if (!within(box, m_frame) || !fits(i, box) || liesOver(*m_request.drawn, box))
      continue;
    for (std::size_t bend = 0; bend < leaderBends.size(); bend += bendStep) {
      const Leader leader = leaderOf(column, placeOf(one), box, leaderBends[bend]);
      m_placed[i] = PlacedLabel{one.id, post, box, leader, one.hidden};
      if (standsClear(i))
        return true;
    }
  }
  m_placed[i].reset();
  return false;
}

}  // namespace sline::render
