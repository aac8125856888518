// SPDX-License-Identifier: Apache-2.0
#include "render/labels/layouter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <tuple>

namespace sline::render {

namespace {
constexpr float stay = 0.25f;  // of the anatomy's width past its middle: sides stay
}

void Layouter::setRanks() {
  // Only steps of two count, so that a list's order decides among what is about as large; and what
  // was put on a place by hand comes before names. In a film it is the list's order alone, as the
  // same labels must stand from picture to picture.
  const auto size = [this](std::size_t i) {
    if (m_request.still)
      return std::numeric_limits<int>::max();
    if (item(i).focus || item(i).kind != model::AnnotationKind::label)
      return std::numeric_limits<int>::max();
    return item(i).seen > 0.0f ? std::ilogb(item(i).seen) : std::numeric_limits<int>::min();
  };
  m_order.resize(m_request.items.size());
  std::iota(m_order.begin(), m_order.end(), std::size_t(0));
  std::stable_sort(m_order.begin(), m_order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  m_ranks.resize(m_order.size());
  for (std::size_t rank = 0; rank < m_order.size(); ++rank)
    m_ranks[m_order[rank]] = rank;
}

LabelLayout Layouter::layOut() {
  setColumns();
  choosePosts();
  const std::vector<Fate> chosen = m_fates;
  widen();
  settle();
  if (!follows() && !m_request.still) {
    if (narrow())
      settle();
    comeBack(chosen);
    if (m_request.drawn)
      fillEdges();
  }
  return answer();
}

void Layouter::settle() {
  // Each round sends an item to the other side or out, so that this ends.
  for (std::size_t rounds = 0; rounds <= 3 * m_fates.size(); ++rounds) {
    letWideIn();
    place();
    const std::optional<std::size_t> loser = firstLoser();
    if (!loser)
      break;
    giveWay(*loser);
  }
}

void Layouter::comeBack(const std::vector<Fate>& chosen) {
  m_bending = true;
  for (const bool hidden : {false, true})
    for (const std::size_t i : m_order) {
      if (!m_fates[i].out || chosen[i].out || !isColumn(chosen[i].post) || item(i).hidden != hidden)
        continue;
      const std::vector<Fate> fates = m_fates;
      const std::vector<std::optional<PlacedLabel>> placed = m_placed;
      const std::array<float, 2> widths = m_widths;
      m_fates[i] = chosen[i];
      bool better = item(i).box.x <= m_widths[chosen[i].post == LabelPost::left ? 0 : 1] &&
                    fit(chosen[i].post);
      if (better) {
        place();
        better = !m_fates[i].out && !firstLoser();
      }
      if (better)
        continue;
      m_fates = fates;
      m_placed = placed;
      m_widths = widths;
    }
}

std::vector<std::pair<std::size_t, std::size_t>> Layouter::conflicts() {
  setColumns();
  choosePosts();
  widen();
  place();
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < m_fates.size(); ++i) {
    if (m_fates[i].out || !m_placed[i] || misplaced(i)) {
      pairs.emplace_back(i, i);
      continue;
    }
    for (std::size_t k = 0; k < i; ++k)
      if (m_placed[k] && inConflict(i, k))
        pairs.emplace_back(k, i);
  }
  return pairs;
}

float Layouter::calm(std::size_t i) const {
  constexpr float never = 360.0f;
  const glm::vec3 jumpedAt = lastJump(i);
  if (jumpedAt == glm::vec3(0.0f))
    return never;
  return glm::degrees(std::acos(std::clamp(glm::dot(jumpedAt, m_request.towardsEye), -1.0f, 1.0f)));
}

glm::vec3 Layouter::lastJump(std::size_t i) const {
  if (const PlacedLabel* was = before(i))
    return was->jumpedAt;
  if (m_before)
    for (const WaitingLabel& waiting : m_before->waiting)
      if (waiting.id == item(i).id)
        return waiting.jumpedAt;
  return glm::vec3(0.0f);
}

LabelPost Layouter::sideOf(std::size_t i) const {
  if (item(i).side)
    return *item(i).side;
  const float x = placeOf(item(i)).x - m_middle;
  const PlacedLabel* was = before(i);
  const PlacedLabel* home = this->home(i);
  if (home && isColumn(home->post) && !(was && isColumn(was->post) && rests(i)))
    return home->post;
  if (was && isColumn(was->post)) {
    const float past = was->post == LabelPost::left ? x : -x;
    return past > stay * m_width && calm(i) > restDegrees ? otherSide(was->post) : was->post;
  }
  return x < 0.0f ? LabelPost::left : LabelPost::right;
}

void Layouter::choosePosts() {
  for (std::size_t i = 0; i < m_fates.size(); ++i) {
    const LabelItem& one = item(i);
    const bool nowhere = m_request.still && !one.height && !one.offset && !standsBeside(one);
    m_fates[i].out = one.absent || nowhere || one.places.empty() || !hasRoom(m_frame, one.box) ||
                     !(one.box.x > 0.0f) || !(one.box.y > 0.0f) || (rests(i) && !before(i));
    m_fates[i].tried = one.side.has_value();
    m_fates[i].post = one.offset          ? LabelPost::byHand
                      : standsBeside(one) ? LabelPost::beside
                                          : sideOf(i);
  }
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && isColumn(m_fates[i].post) && tooWide(i)) {
      m_fates[i].out = true;
      m_wide.push_back(i);
    }
}

void Layouter::letWideIn() {
  const auto stands = [](const Fate& fate) { return !fate.out && isColumn(fate.post); };
  if (m_wide.empty() || std::any_of(m_fates.begin(), m_fates.end(), stands))
    return;
  m_fates[m_wide.front()].out = false;
  m_wide.erase(m_wide.begin());
}

bool Layouter::fitsAcross(std::size_t i) {
  LabelPost& post = m_fates[i].post;
  post = otherSide(post);
  const bool fits = fit(post);
  post = otherSide(post);
  return fits;
}

void Layouter::relieve(LabelPost post) {
  const auto distance = [&](std::size_t i) { return std::abs(placeOf(item(i)).x - m_middle); };
  // What is in focus goes out last. Of the others those that came from the other side go first,
  // then hidden ones, then those that did not stand before, then the least important.
  const auto worth = [&](std::size_t i) {
    return std::tuple(item(i).focus, !m_fates[i].tried, !item(i).hidden, before(i) != nullptr,
                      -std::ptrdiff_t(m_ranks[i]));
  };
  m_crowded = m_crowded || (!fit(post) && !fit(otherSide(post)));
  while (!fit(post)) {
    std::optional<std::size_t> goes;
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < m_fates.size(); ++i) {
      if (m_fates[i].out || m_fates[i].post != post)
        continue;
      if (!m_crowded && !m_fates[i].tried && !rests(i) &&
          (!goes || distance(i) < distance(*goes)) && fitsAcross(i))
        goes = i;
      if (!least || worth(i) < worth(*least))
        least = i;
    }
    m_crowded = m_crowded || !goes;
    if (goes)
      giveWay(*goes);
    else
      m_fates[*least].out = true;
  }
}

bool Layouter::inConflict(std::size_t i, std::size_t j) const {
  const PlacedLabel& a = *m_placed[i];
  const PlacedLabel& b = *m_placed[j];
  const auto passes = [](const PlacedLabel& label, const LabelItem& other) {
    return std::any_of(other.places.begin(), other.places.end(),
                       [&](const glm::vec2& place) { return passesDot(label.leader, place); });
  };
  return overlap(a.box, b.box) || cross(a.leader, b.leader) || passes(a, item(j)) ||
         passes(b, item(i)) || runsThrough(a.leader, b.box.grown(clearance)) ||
         runsThrough(b.leader, a.box.grown(clearance));
}

/// Decides which of two items gives way. A label moved by hand wins. A label that has another side
/// to try goes there: first the cause, the one with a leader through the other's box, then the one
/// that has not jumped for longer. In a film, where none may, the one whose place is farther past
/// the middle is left out. Otherwise a seen label wins over a hidden one, then the more important.
std::size_t Layouter::loserOf(std::size_t i, std::size_t j) const {
  const auto rank = [&](std::size_t k, std::size_t other) {
    const bool cause = runsThrough(m_placed[k]->leader, m_placed[other]->box.grown(clearance));
    const float rested = m_fates[k].tried ? 0.0f : calm(k);
    const float past = placeOf(item(k)).x - m_middle;
    const float astray = !item(k).side                     ? 0.0f
                         : item(k).side == LabelPost::left ? std::max(past, 0.0f)
                                                           : std::max(-past, 0.0f);
    return std::tuple(m_placed[k]->post != LabelPost::byHand, !m_fates[k].tried, !item(k).focus,
                      astray, cause, rested, item(k).hidden, m_ranks[k]);
  };
  return rank(i, j) < rank(j, i) ? j : i;
}

std::optional<std::size_t> Layouter::firstLoser() const {
  for (std::size_t i = 0; i < m_fates.size(); ++i)
    if (!m_fates[i].out && (!m_placed[i] || misplaced(i)))
      return i;
  for (std::size_t i = 0; i < m_placed.size(); ++i)
    for (std::size_t j = i + 1; j < m_placed.size(); ++j)
      if (m_placed[i] && m_placed[j] && inConflict(i, j))
        return loserOf(i, j);
  return std::nullopt;
}

void Layouter::giveWay(std::size_t i) {
  Fate& fate = m_fates[i];
  if (rests(i) || m_request.still ||
      (isColumn(fate.post) && (fate.tried || m_crowded || !fitsAcross(i)))) {
    fate.out = true;
  } else if (isColumn(fate.post)) {
    fate.post = otherSide(fate.post);
    fate.tried = true;
  } else {
    fate.post = sideOf(i);
    fate.out = tooWide(i);
  }
}

LabelLayout Layouter::answer() const {
  LabelLayout layout{.labels = {},
                     .leftOut = {},
                     .waiting = {},
                     .edges = m_edges,
                     .widths = m_widths,
                     .textWidth = m_request.textWidth};
  for (std::size_t i = 0; i < m_placed.size(); ++i) {
    const PlacedLabel* was = before(i);
    const bool in = m_placed[i] && !m_fates[i].out;
    const bool jumped = in && m_before && (!was || jumps(*was, *m_placed[i]));
    if (in && !(jumped && rests(i))) {
      layout.labels.push_back(*m_placed[i]);
      layout.labels.back().jumpedAt = jumped ? m_request.towardsEye : lastJump(i);
      layout.labels.back().found = item(i).found;
    } else {
      layout.leftOut.push_back(item(i).id);
      if (lastJump(i) != glm::vec3(0.0f))
        layout.waiting.push_back({item(i).id, lastJump(i)});
    }
  }
  return layout;
}

}  // namespace sline::render
