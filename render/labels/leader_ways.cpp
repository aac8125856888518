// SPDX-License-Identifier: Apache-2.0
// Leads leaders of labels past each other where their boxes stay.
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "render/labels/layouter.h"
#include "render/labels/leader_bends.h"

namespace sline::render {

namespace {

float lengthOf(const Leader& leader) {
  float length = 0.0f;
  for (std::size_t k = 1; k < leader.size(); ++k)
    length += glm::distance(leader[k - 1], leader[k]);
  return length;
}

/// Returns level and upright ways to the box, the shortest first; they may go round what lies
/// between the place and the box.
std::vector<Leader> waysRound(const glm::vec2& place, const LabelBox& box, const LabelBox& frame) {
  constexpr int corridors = 28;
  constexpr float shortest = 1.0f;
  constexpr float rounding = 1e-3f;
  const glm::vec2 middle = box.middle();
  std::vector<Leader> ways;
  for (const float y : {box.low.y, box.high.y})
    ways.push_back({place, {middle.x, place.y}, {middle.x, y}});
  for (const float x : {box.low.x, box.high.x}) {
    ways.push_back({place, {place.x, middle.y}, {x, middle.y}});
    for (int i = 0; i <= corridors; ++i) {
      const float at = frame.low.x + frame.size().x * float(i) / float(corridors);
      ways.push_back({place, {at, place.y}, {at, middle.y}, {x, middle.y}});
      if (at > box.low.x && at < box.high.x)
        ways.push_back({place, {at, place.y}, {at, place.y < middle.y ? box.low.y : box.high.y}});
    }
  }
  std::erase_if(ways, [&](const Leader& way) {
    for (std::size_t k = 1; k < way.size(); ++k)
      if (glm::distance(way[k - 1], way[k]) < shortest)
        return true;
    return runsThrough(way, box.grown(-rounding));
  });
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Leader& a, const Leader& b) { return lengthOf(a) < lengthOf(b); });
  return ways;
}

/// Returns the ways above and below that box on the way to the column.
std::vector<Leader> waysPast(const LabelBox& past, const glm::vec2& place, const LabelBox& box,
                             const Column& column) {
  const float inwards = column.left ? 1.0f : -1.0f;
  const LabelBox round = past.grown(2.0f * clearance);
  const float near = column.left ? round.high.x : round.low.x;
  const float far = column.left ? round.low.x : round.high.x;
  const float knee = column.edge + inwards * levelPiece;
  const float middle = box.middle().y;
  std::vector<Leader> ways;
  if (inwards * (place.x - near) > 0.0f && inwards * (far - knee) > 0.0f)
    for (const float y : {round.low.y, round.high.y})
      ways.push_back({place, {near, y}, {far, y}, {knee, middle}, {column.edge, middle}});
  return ways;
}

}  // namespace

std::vector<Leader> Layouter::waysOf(std::size_t i) const {
  const PlacedLabel& label = *m_placed[i];
  std::vector<Leader> ways{label.leader};
  if (label.leader.empty())
    return ways;
  const glm::vec2 place = label.leader.front();
  if (label.post == LabelPost::byHand) {
    const std::vector<Leader> round = waysRound(place, label.box, m_frame);
    ways.insert(ways.end(), round.begin(), round.end());
  } else if (isColumn(label.post)) {
    for (const LeaderBend& bend : leaderBends)
      ways.push_back(leaderOf(column(label.post), place, label.box, bend));
  }
  return ways;
}

std::size_t Layouter::conflictsOf(std::size_t i) const {
  std::size_t conflicts = misplaced(i) ? m_placed.size() : 0;
  for (std::size_t k = 0; k < m_placed.size(); ++k)
    conflicts += k != i && m_placed[k] && inConflict(i, k) ? 1 : 0;
  return conflicts;
}

void Layouter::bend(std::size_t i, const std::vector<Leader>& ways) {
  PlacedLabel& label = *m_placed[i];
  Leader best = label.leader;
  std::size_t least = conflictsOf(i);
  for (const Leader& way : ways) {
    if (least == 0)
      break;
    label.leader = way;
    if (const std::size_t conflicts = conflictsOf(i); conflicts < least) {
      least = conflicts;
      best = way;
    }
  }
  label.leader = std::move(best);
}

std::vector<Leader> Layouter::bestWaysOf(std::size_t i) {
  constexpr std::size_t most = 6;
  const Leader own = m_placed[i]->leader;
  std::vector<std::pair<std::size_t, Leader>> ways;
  for (Leader& way : waysOf(i)) {
    m_placed[i]->leader = way;
    ways.emplace_back(conflictsOf(i), std::move(way));
  }
  m_placed[i]->leader = own;
  // The straight one is tried first, in case others can go past it.
  std::stable_sort(ways.begin() + 1, ways.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Leader> best;
  for (std::size_t k = 0; k < std::min(most, ways.size()); ++k)
    best.push_back(std::move(ways[k].second));
  return best;
}

void Layouter::bendRound(std::size_t hand) {
  const std::vector<std::optional<PlacedLabel>> placed = m_placed;
  std::vector<std::optional<PlacedLabel>> best;
  std::size_t least = m_placed.size() + 1;
  for (const Leader& way : bestWaysOf(hand)) {
    m_placed = placed;
    m_placed[hand]->leader = way;
    for (std::size_t i = 0; i < m_placed.size(); ++i)
      if (m_placed[i] && isColumn(m_placed[i]->post) && inConflict(i, hand))
        bend(i, waysOf(i));
    if (const std::size_t conflicts = conflictsOf(hand); conflicts < least) {
      least = conflicts;
      best = m_placed;
    }
    if (least == 0)
      break;
  }
  if (!best.empty())
    m_placed = std::move(best);
  for (std::size_t i = 0; least > 0 && i < m_placed.size(); ++i)
    if (m_placed[i] && isColumn(m_placed[i]->post) && inConflict(i, hand))
      bend(i, waysRoundHand(i, hand));
}

std::vector<Leader> Layouter::waysRoundHand(std::size_t i, std::size_t hand) const {
  const PlacedLabel& label = *m_placed[i];
  const glm::vec2 place = placeOf(item(i));
  std::vector<Leader> ways = waysPast(m_placed[hand]->box, place, label.box, column(label.post));
  const std::vector<Leader> round = waysRound(place, label.box, m_frame);
  ways.insert(ways.end(), round.begin(), round.end());
  return ways;
}

void Layouter::bendApart() {
  const std::size_t count = m_placed.size();
  for (std::size_t i = 0; i < count; ++i)
    if (m_placed[i] && m_placed[i]->post == LabelPost::byHand && conflictsOf(i) > 0)
      bendRound(i);
  if (m_request.still)
    bendSteadily();
  else if (m_bending || follows())
    unravel({column(LabelPost::left), column(LabelPost::right)});
}

void Layouter::setBend(std::size_t i, const Column& column, std::size_t bend) {
  PlacedLabel& label = *m_placed[i];
  label.bend = bend;
  label.leader = leaderOf(column, placeOf(item(i)), label.box, leaderBends[bend]);
}

std::size_t Layouter::unravel(const std::array<Column, 2>& columns) {
  std::size_t all = 0;
  for (bool fewer = true; fewer;) {
    fewer = false;
    all = 0;
    for (std::size_t i = 0; i < m_placed.size(); ++i) {
      if (!m_placed[i] || !isColumn(m_placed[i]->post))
        continue;
      const Column& column = columns[m_placed[i]->post == LabelPost::left ? 0 : 1];
      const std::size_t now = conflictsOf(i);
      std::size_t least = now;
      std::size_t best = m_placed[i]->bend;
      const std::size_t own = best;
      for (std::size_t bend = 0; bend < leaderBends.size() && least > 0; ++bend) {
        setBend(i, column, bend);
        if (const std::size_t conflicts = conflictsOf(i); conflicts < least) {
          least = conflicts;
          best = bend;
        }
      }
      if (now > 0)
        setBend(i, column, best);
      fewer = fewer || best != own;
      all += least;
    }
  }
  return all;
}

void Layouter::bendSteadily() {
  const std::array<Column, 2> columns{column(LabelPost::left), column(LabelPost::right)};
  std::size_t least = unravel(columns);
  std::vector<std::optional<PlacedLabel>> best = m_placed;
  // In the order of their places, leaders that leave these level never meet.
  for (const std::size_t start : {std::size_t(0), leaderBends.size() - 1}) {
    if (least == 0)
      break;
    for (std::size_t i = 0; i < m_placed.size(); ++i)
      if (m_placed[i] && isColumn(m_placed[i]->post))
        setBend(i, columns[m_placed[i]->post == LabelPost::left ? 0 : 1], start);
    if (const std::size_t conflicts = unravel(columns); conflicts < least) {
      least = conflicts;
      best = m_placed;
    }
  }
  m_placed = std::move(best);
}

}  // namespace sline::render
