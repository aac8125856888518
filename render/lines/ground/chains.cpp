// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/chains.h"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
constexpr std::uint32_t none = ~0u;
constexpr std::uint32_t crowded = ~0u - 1;

/// Returns an end of a segment: end 2i is segment i's a, end 2i + 1 its b.
const glm::vec3& pointOf(const std::vector<Segment>& segments, std::uint32_t end) {
  const Segment& s = segments[end / 2];
  return end % 2 == 0 ? s.a : s.b;
}

std::uint32_t hashOf(const glm::vec3& p) {
  std::uint64_t h = 0;
  for (const float x : {p.x, p.y, p.z})
    h = (h ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
  return std::uint32_t(h >> 32);
}

/// Returns for each end the only other end at the same point; `none` where there is no other or
/// where three or more meet. Open addressing: one slot per distinct point, with its hash, so that
/// other points are rarely looked at.
std::vector<std::uint32_t> partners(const std::vector<Segment>& segments) {
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t end = none;
  };
  const std::uint32_t count = std::uint32_t(2 * segments.size());
  const std::uint32_t mask = std::bit_ceil(std::max(count + count / 2, 16u)) - 1;
  std::vector<Slot> slots(mask + 1);
  std::vector<std::uint32_t> partner(count, none);
  for (std::uint32_t end = 0; end < count; ++end) {
    const glm::vec3& p = pointOf(segments, end);
    const std::uint32_t hash = hashOf(p);
    std::uint32_t at = hash & mask;
    while (slots[at].end != none &&
           !(slots[at].hash == hash && pointOf(segments, slots[at].end) == p))
      at = (at + 1) & mask;
    const std::uint32_t seen = slots[at].end;
    if (seen == none) {
      slots[at] = {hash, end};
    } else if (partner[seen] == none) {
      partner[seen] = end;
      partner[end] = seen;
    } else {
      if (partner[seen] != crowded)
        partner[partner[seen]] = crowded;
      partner[seen] = partner[end] = crowded;
    }
  }
  std::replace(partner.begin(), partner.end(), crowded, none);
  return partner;
}
}  // namespace

Chains connectedChains(const std::vector<Segment>& segments) {
  const std::vector<std::uint32_t> partner = partners(segments);
  Chains chains;
  chains.links.reserve(segments.size());
  std::vector<bool> taken(segments.size());
  // Follows the line that leaves segment start / 2 at its other end.
  const auto walk = [&](std::uint32_t start) {
    chains.first.push_back(std::uint32_t(chains.links.size()));
    for (std::uint32_t end = start; end != none && !taken[end / 2]; end = partner[end ^ 1u]) {
      taken[end / 2] = true;
      chains.links.push_back({end / 2, end % 2 == 1});
    }
  };
  for (std::uint32_t end = 0; end < partner.size(); ++end)
    if (partner[end] == none && !taken[end / 2])
      walk(end);
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (!taken[i])
      walk(2 * i);  // a closed line
  chains.first.push_back(std::uint32_t(chains.links.size()));
  return chains;
}

std::vector<float> chainLengths(const Chains& chains, const std::vector<Segment>& segments) {
  std::vector<float> lengths(chains.count(), 0.0f);
  for (std::size_t chain = 0; chain < chains.count(); ++chain)
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
      const Segment& s = segments[chains.links[i].segment];
      lengths[chain] += glm::distance(s.a, s.b);
    }
  return lengths;
}

void fadeShortChains(std::vector<Segment>& segments, const Chains& chains,
                     std::span<const float> lengths, const Specks& specks) {
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    const float share = std::clamp(
        (lengths[chain] - specks.shortest) / std::max(specks.whole - specks.shortest, 1e-6f), 0.0f,
        1.0f);
    if (share >= 1.0f)
      continue;
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
      segments[chains.links[i].segment].opacityA *= share;
      segments[chains.links[i].segment].opacityB *= share;
    }
  }
}

namespace {
Segment inOrder(const Segment& s, bool reversed) {
  if (!reversed)
    return s;
  Segment turned = s;
  std::swap(turned.a, turned.b);
  std::swap(turned.normalA, turned.normalB);
  std::swap(turned.opacityA, turned.opacityB);
  std::swap(turned.entryA, turned.entryB);
  std::swap(turned.gammaA, turned.gammaB);
  std::swap(turned.moveA, turned.moveB);
  std::swap(turned.pressureA, turned.pressureB);
  return turned;
}

float squaredDistance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = b - a;
  const float squared = glm::dot(d, d);
  const float t = squared > 0.0f ? std::clamp(glm::dot(p - a, d) / squared, 0.0f, 1.0f) : 0.0f;
  const glm::vec3 off = p - (a + t * d);
  return glm::dot(off, off);
}

/// Joins the segments of one line; `inner` are the points between the joint's ends so far.
class Joiner {
 public:
  Joiner(float tolerance, float longest, std::vector<Segment>& out)
      : m_squaredTolerance(tolerance * tolerance),
        m_squaredLongest(longest * longest),
        m_out(out) {}

  void add(const Segment& s) {
    if (m_started && fits(s)) {
      m_inner.push_back({m_joint.b, m_joint.b + m_joint.moveB});
      m_joint.b = s.b;
      m_joint.moveB = s.moveB;
      m_joint.pressureB = s.pressureB;
      m_joint.normalB = s.normalB;
      m_joint.opacityB = s.opacityB;
      m_joint.entryB = s.entryB;
      m_joint.gammaB = s.gammaB;
      return;
    }
    finish();
    m_joint = s;
    m_started = true;
  }

  void finish() {
    if (m_started)
      m_out.push_back(m_joint);
    m_started = false;
    m_inner.clear();
  }

 private:
  bool fits(const Segment& s) const {
    const glm::vec3 d = s.b - m_joint.a;
    if (s.concave != m_joint.concave || glm::dot(d, d) > m_squaredLongest)
      return false;
    const glm::vec3 drawnA = m_joint.a + m_joint.moveA;
    const glm::vec3 drawnB = s.b + s.moveB;
    const auto near = [&](const Inner& p) {
      return squaredDistance(p.exact, m_joint.a, s.b) <= m_squaredTolerance &&
             squaredDistance(p.drawn, drawnA, drawnB) <= m_squaredTolerance;
    };
    return near({m_joint.b, m_joint.b + m_joint.moveB}) &&
           std::all_of(m_inner.begin(), m_inner.end(), near);
  }

  /// A point of the line, and where a pen draws it.
  struct Inner {
    glm::vec3 exact;
    glm::vec3 drawn;
  };

  float m_squaredTolerance;
  float m_squaredLongest;
  std::vector<Segment>& m_out;
  std::vector<Inner> m_inner;
  Segment m_joint;
  bool m_started = false;
};
}  // namespace

std::vector<Segment> simplified(const std::vector<Segment>& segments, const Chains& chains,
                                float tolerance, float longest) {
  std::vector<Segment> out;
  out.reserve(segments.size());
  Joiner joiner(tolerance, longest, out);
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i)
      joiner.add(inOrder(segments[chains.links[i].segment], chains.links[i].reversed));
    joiner.finish();
  }
  return out;
}

}  // namespace sline::render
