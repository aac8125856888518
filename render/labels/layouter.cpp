// SPDX-License-Identifier: Apache-2.0
#include "render/labels/layouter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tuple>

namespace sline::render {

namespace {
constexpr float stay = 0.25f;  // of the anatomy's width past its middle: sides stay
}

LabelLayout Layouter::layOut() {
  setColumns();
  choosePosts();
  widen();
  // Each round sends an item to the other side or out, so that this ends.
  for (std::size_t rounds = 0; rounds <= 3 * m_fates.size(); ++rounds) {
    letWideIn();
    place();
    const std::optional<std::size_t> loser = firstLoser();
    if (!loser)
      break;
    giveWay(*loser);
  }
  return answer();
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

void Layouter::relieve(LabelPost post) {
  while (!fit(post)) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < m_fates.size(); ++i) {
      const auto key = [&](std::size_t k) {
        // Those that have not yet tried the other side go there; of the others the least important
        // goes out.
        return m_fates[k].tried ? std::tuple(1, item(k).hidden ? 0 : 1, -float(k))
                                : std::tuple(0, 0, std::abs(placeOf(item(k)).x - m_middle));
      };
      if (!m_fates[i].out && m_fates[i].post == post && (!nearest || key(i) < key(*nearest)))
        nearest = i;
    }
    giveWay(*nearest);
  }
}

bool Layouter::inConflict(std::size_t i, std::size_t j) const {
  const PlacedLabel& a = *m_placed[i];
  const PlacedLabel& b = *m_placed[j];
  return overlap(a.box, b.box) || cross(a.leader, b.leader) ||
         runsThrough(a.leader, b.box.grown(clearance)) ||
         runsThrough(b.leader, a.box.grown(clearance));
}

/// Decides which of two items gives way. A label moved by hand wins. A label that has another side
/// to try goes there: first the cause, the one with a leader through the other's box, then the one
/// that has not jumped for longer. In a film, where none may, the one whose place is farther past
/// the middle is left out. Otherwise a seen label wins over a hidden one, then the earlier.
std::size_t Layouter::loserOf(std::size_t i, std::size_t j) const {
  const auto rank = [&](std::size_t k, std::size_t other) {
    const bool cause = runsThrough(m_placed[k]->leader, m_placed[other]->box.grown(clearance));
    const float rested = m_fates[k].tried ? 0.0f : calm(k);
    const float past = placeOf(item(k)).x - m_middle;
    const float astray = !item(k).side                     ? 0.0f
                         : item(k).side == LabelPost::left ? std::max(past, 0.0f)
                                                           : std::max(-past, 0.0f);
    return std::tuple(m_placed[k]->post != LabelPost::byHand, !m_fates[k].tried, astray, cause,
                      rested, item(k).hidden, k);
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
  if (rests(i) || m_request.still || (isColumn(fate.post) && fate.tried)) {
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
