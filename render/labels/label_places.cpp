// SPDX-License-Identifier: Apache-2.0
// Gives labels their places in columns, beside what they point at and where they were put by hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "render/labels/layouter.h"
#include "render/labels/steady_column.h"

namespace sline::render {

namespace {

constexpr float anatomyGapMost = 14.0f;  // the anatomy recedes this far before a column follows
constexpr float slack = 12.0f;           // between a place's height and that of its box
constexpr float mostAir = 4.0f;          // between boxes of a column, where there is room
constexpr float leastAir = 1.2f;         // the same, for columns that are higher than the anatomy
constexpr float besideGap = 1.8f;        // between a place and a box beside it

}  // namespace

void Layouter::setColumns() {
  LabelBox all{glm::vec2(std::numeric_limits<float>::infinity()),
               glm::vec2(-std::numeric_limits<float>::infinity())};
  for (const LabelItem& item : m_request.items) {
    all.low = glm::min(all.low, placeOf(item));
    all.high = glm::max(all.high, placeOf(item));
  }
  if (m_request.obstacles.extent)
    all = *m_request.obstacles.extent;
  m_middle = middleBetweenColumns(m_request.items, all);
  m_width = all.size().x;
  m_near = edgesBeside(all);
  if (m_home && !m_home->labels.empty()) {
    m_near = m_home->edges;
    m_widths = m_home->widths;
  } else if (m_request.still) {
    m_widths = m_request.widths;
  } else if (m_before && !m_before->labels.empty()) {
    const float most = anatomyGapMost - anatomyGap;
    m_near[0] = std::clamp(m_before->edges[0], m_near[0] - most, m_near[0]);
    m_near[1] = std::clamp(m_before->edges[1], m_near[1], m_near[1] + most);
    m_widths = m_before->widths;
  }
}

void Layouter::widen() {
  float widest = 0.0f;
  std::array<float, 2> widths{};
  for (std::size_t i = 0; i < m_fates.size(); ++i) {
    if (!tooWide(i))
      widest = std::max(widest, item(i).box.x);
    if (!m_fates[i].out && isColumn(m_fates[i].post)) {
      float& width = widths[m_fates[i].post == LabelPost::left ? 0 : 1];
      width = std::max(width, item(i).box.x);
    }
  }
  for (std::size_t side = 0; side < 2; ++side)
    if (widths[side] > m_widths[side])
      m_widths[side] = follows() ? std::max(widest, widths[side]) : widths[side];
  m_edges = edgesOf(m_near, m_frame, m_widths);
  findDrawn();
}

void Layouter::findDrawn() {
  if (!m_request.drawn || m_request.still)
    return;
  for (const std::size_t side : {0, 1}) {
    const Span across = acrossColumn(side);
    if (across == m_across[side])
      continue;
    m_across[side] = across;
    m_overDrawn[side] = heightsOver(*m_request.drawn, across);
  }
}

bool Layouter::narrow() {
  const std::array<float, 2> before = m_widths;
  m_widths = {};
  widen();
  return m_widths != before;
}

Column Layouter::column(LabelPost post) const {
  return {.left = post == LabelPost::left,
          .edge = m_edges[post == LabelPost::left ? 0 : 1],
          .top = m_frame.low.y,
          .bottom = m_frame.high.y,
          .gap = columnGap,
          .blocked = blockedIn(post)};
}

Span Layouter::acrossColumn(std::size_t side) const {
  const float edge = m_edges[side];
  return side == 0 ? Span{edge - m_widths[0], edge} : Span{edge, edge + m_widths[1]};
}

std::vector<Span> Layouter::blockedIn(LabelPost post) const {
  const std::size_t side = post == LabelPost::left ? 0 : 1;
  const Span across = acrossColumn(side);
  std::vector<Span> blocked = m_overDrawn[side];
  const auto block = [&](const LabelBox& box) {
    if (box.low.x < across.high && box.high.x > across.low)
      blocked.push_back({box.low.y - clearance, box.high.y + clearance});
  };
  for (const LabelBox& box : m_request.space.reserved)
    block(box.grown(clearance));
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && m_fates[i].post == post)
      for (const glm::vec2& place : item(i).places)
        if (place.x + dotRoom > across.low && place.x - dotRoom < across.high)
          blocked.push_back({place.y - dotRoom, place.y + dotRoom});
  for (const std::optional<PlacedLabel>& placed : m_placed)
    if (placed && placed->post == LabelPost::byHand) {
      // Those beside it may touch it, so that they need not go far.
      constexpr float before = levelPiece + 3.0f * clearance;
      const float low = side == 0 ? across.low : across.low - before;
      const float high = side == 0 ? across.high + before : across.high;
      if (placed->box.low.x < high && placed->box.high.x > low)
        blocked.push_back({placed->box.low.y, placed->box.high.y});
      if (const auto heights = heightsWithin(placed->leader, across.low, across.high))
        blocked.push_back({heights->low - clearance, heights->high + clearance});
    }
  return blocked;
}

std::vector<ColumnItem> Layouter::inColumn(LabelPost post) const {
  std::vector<ColumnItem> items;
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && m_fates[i].post == post)
      items.push_back({i, placeOf(item(i)), item(i).box, calm(i), wantedHeight(i)});
  const auto height = [&](const ColumnItem& one) {
    const PlacedLabel* was = stands(one.item);
    return was && was->post == post ? was->box.middle().y : one.wanted;
  };
  std::stable_sort(items.begin(), items.end(),
                   [&](const ColumnItem& a, const ColumnItem& b) { return height(a) < height(b); });
  return items;
}

/// Returns the height of the item's place, or the one where it stood before, as long as that is
/// near enough or no farther than it was: it then need not move when others come and go.
float Layouter::wantedHeight(std::size_t i) const {
  const float height = placeOf(item(i)).y;
  const PlacedLabel* was = stands(i);
  if (!was || was->post != m_fates[i].post || was->leader.empty())
    return height;
  const float stood = was->box.middle().y;
  if (was == home(i))
    return stood;
  const float far = std::max(slack, std::abs(stood - was->leader.front().y));
  return std::clamp(stood, height - far, height + far);
}

void Layouter::place() {
  std::fill(m_placed.begin(), m_placed.end(), std::nullopt);
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && m_fates[i].post == LabelPost::byHand)
      placeByHand(i);
  widen();
  // Items that do not fit on one side go to the other and from there out, so that this ends.
  while (!m_request.still && (!fit(LabelPost::left) || !fit(LabelPost::right))) {
    relieve(LabelPost::left);
    relieve(LabelPost::right);
    widen();
  }
  placeColumn(LabelPost::left);
  placeColumn(LabelPost::right);
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && m_fates[i].post == LabelPost::beside)
      placeBeside(i);
  bendApart();
}

void Layouter::placeByHand(std::size_t i) {
  const glm::vec2 half = 0.5f * item(i).box;
  const glm::vec2 place = placeOf(item(i));
  const glm::vec2 middle = glm::clamp(item(i).base.value_or(place) + *item(i).offset,
                                      m_frame.low + half, m_frame.high - half);
  const LabelBox box =
      besideReserved({middle - half, middle + half}, m_frame, m_request.space.reserved);
  m_placed[i] =
      PlacedLabel{item(i).id, LabelPost::byHand, box, leaderToHand(box, place), item(i).hidden};
}

Leader Layouter::leaderToHand(const LabelBox& box, const glm::vec2& place) const {
  Leader straight = leaderTo(box, place);
  // Within a column it is level, so that it takes none of its room.
  for (const LabelPost post : {LabelPost::left, LabelPost::right}) {
    const bool left = post == LabelPost::left;
    const float inwards = left ? 1.0f : -1.0f;
    const float edge = m_edges[left ? 0 : 1];
    const float end = left ? box.high.x : box.low.x;
    const float knee = (left ? std::max(edge, end) : std::min(edge, end)) + inwards * levelPiece;
    if (!straight.empty() && inwards * (edge - end) > -levelPiece &&
        inwards * (place.x - knee) > levelPiece)
      return {place, {knee, box.middle().y}, {end, box.middle().y}};
  }
  return straight;
}

bool Layouter::misplaced(std::size_t i) const {
  const PlacedLabel& label = *m_placed[i];
  const std::vector<LabelBox>& reserved = m_request.space.reserved;
  constexpr float rounding = 1e-3f;
  const bool own =
      label.post != LabelPost::byHand &&
      (coversOwn(item(i), label.box) || runsThrough(label.leader, label.box.grown(-rounding)));
  const bool overDrawn = m_request.drawn && !m_request.still && isColumn(label.post) &&
                         liesOver(*m_request.drawn, label.box);
  return own || overDrawn || !within(label.box, m_frame) ||
         std::any_of(reserved.begin(), reserved.end(), [&](const LabelBox& one) {
           return overlap(label.box, one) ||
                  (label.post != LabelPost::byHand && runsThrough(label.leader, one));
         });
}

void Layouter::put(const ColumnItem& one, LabelPost post, const ColumnPlacement& place) {
  const LabelItem& whose = item(one.item);
  m_placed[one.item] = PlacedLabel{whose.id, post, place.box, place.leader, whose.hidden};
}

void Layouter::placeAtHeights(LabelPost post) {
  const Column column = this->column(post);
  for (std::size_t i = 0; i < m_fates.size(); ++i) {
    if (m_fates[i].out || m_fates[i].post != post)
      continue;
    const glm::vec2 box = item(i).box;
    const glm::vec2 corner(column.left ? column.edge - box.x : column.edge,
                           *item(i).height - 0.5f * box.y);
    m_placed[i] = PlacedLabel{item(i).id, post, {corner, corner + box}, {}, item(i).hidden};
    const PlacedLabel* was = before(i);
    setBend(i, column, was && was->post == post ? was->bend : 0);
  }
}

void Layouter::placeColumn(LabelPost post) {
  if (m_request.still) {
    placeAtHeights(post);
    return;
  }
  std::vector<ColumnItem> items = inColumn(post);
  if ((m_before || m_home) && placeSteadily(post, items))
    return;
  // Leaves air between the items where there is room, so that later ones find a gap.
  Column airy = column(post);
  float room = 0.0f;
  for (const Span& span : freeSpans(airy))
    room += span.length();
  const float height = heightOf(items);
  const float number = float(std::max<std::size_t>(items.size(), 1));
  const float anatomy = m_request.obstacles.extent ? m_request.obstacles.extent->size().y : room;
  if (!m_before || m_before->labels.empty())
    airy.gap += std::clamp((room - height) / (2.0f * number + 1.0f), 0.0f,
                           std::clamp((anatomy - height) / number, leastAir, mostAir));
  if (!fitIn(airy, items))
    airy.gap = columnGap;
  uncross(airy, items);
  const std::vector<ColumnPlacement> places = placesIn(airy, items);
  for (std::size_t k = 0; k < items.size(); ++k)
    put(items[k], post, places[k]);
}

bool Layouter::placeSteadily(LabelPost post, const std::vector<ColumnItem>& items) {
  std::vector<ColumnItem> staying;
  std::vector<ColumnItem> coming;
  for (const ColumnItem& one : items) {
    const PlacedLabel* was = stands(one.item);
    (was && was->post == post ? staying : coming).push_back(one);
  }
  SteadyColumn steady(column(post), m_request.moving);
  if (!steady.fill(std::move(staying), std::move(coming)))
    return false;
  for (std::size_t k = 0; k < steady.items().size(); ++k)
    put(steady.items()[k], post, steady.places()[k]);
  for (const std::size_t out : steady.out())
    m_fates[out].out = true;
  return true;
}

bool Layouter::fits(std::size_t i, const LabelBox& box) const {
  if (!within(box, m_frame) || overlapAny(box, m_request.space.reserved) || coversOwn(item(i), box))
    return false;
  for (std::size_t k = 0; k < m_placed.size(); ++k) {
    if (k == i)
      continue;
    if (m_placed[k] && (overlap(box.grown(clearance), m_placed[k]->box) ||
                        runsThrough(m_placed[k]->leader, box.grown(clearance))))
      return false;
    for (const glm::vec2& place : item(k).places)
      if (!m_fates[k].out && box.grown(clearance).contains(place))
        return false;
  }
  return true;
}

void Layouter::placeBeside(std::size_t i) {
  constexpr std::array<std::array<float, 2>, 8> ways{
      {{1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}}};
  const glm::vec2 place = placeOf(item(i));
  const PlacedLabel* was = before(i);
  std::optional<LabelBox> best;
  float bestCost = 0.0f;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const glm::vec2 way(ways[k][0], ways[k][1]);
    const glm::vec2 middle = place + way * (0.5f * item(i).box + besideGap);
    const LabelBox box{middle - 0.5f * item(i).box, middle + 0.5f * item(i).box};
    if (!fits(i, box))
      continue;
    const auto sign = [](float a) { return a > 0.5f ? 1.0f : a < -0.5f ? -1.0f : 0.0f; };
    bool same = false;
    if (was && was->post == LabelPost::beside) {
      const glm::vec2 offset = was->box.middle() - place;
      same = sign(offset.x) == way.x && sign(offset.y) == way.y;
    }
    const float cost = m_request.obstacles.share(box) + 0.05f * float(k) - (same ? 1.5f : 0.0f);
    if (!best || cost < bestCost) {
      best = box;
      bestCost = cost;
    }
  }
  if (best)
    m_placed[i] = PlacedLabel{item(i).id, LabelPost::beside, *best, {}, item(i).hidden};
}

}  // namespace sline::render
