// SPDX-License-Identifier: Apache-2.0
#include "render/measures/leader_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "model/scene/resolved_styles.h"

namespace sline::render {

namespace {

/// What differs by less is taken for ground: a fifteenth of the way between the loud colours.
constexpr std::uint8_t faint = 17;
/// The share of a dot that must show the structure so that one knows what it lies on. A line as
/// wide as the usual pen that runs under the dot covers more.
constexpr float enough = 0.3f;
/// The share of a dot below which one takes it for ground.
constexpr float little = 0.1f;
/// The share of a structure's surface that must reach the eye through what is before it, so that
/// its inside is said to be seen where nothing is drawn.
constexpr float reaches = 0.35f;
/// A dot and the light rim around it, and how far about it one looks: radii.
constexpr float haloed = 1.7f;
constexpr float near = 4.0f;
/// What must show there beside the dot, in dots, so that one sees what the dot is on; and what is
/// enough for everybody to see it.
constexpr float leastAround = 0.25f;
constexpr float plentyAround = 1.0f;

/// How much of a structure one sees at each pixel, 0 … 255.
using Shares = std::vector<std::uint8_t>;

class Judge {
 public:
  Judge(const DrawPicture& draw, const JudgedPicture& picture)
      : m_draw(draw),
        m_picture(picture),
        m_width(picture.settings.width),
        m_height(picture.settings.height) {}

  /// Finds what one sees at every pixel.
  Status look() {
    const std::size_t pixels = std::size_t(m_width) * std::size_t(m_height);
    m_seen.assign(pixels, 0);
    m_most.assign(pixels, faint);
    const std::array<model::NodeId, 1> all{model::rootId};
    for (const model::ResolvedStructure& one : model::resolvedBelow(m_picture.scene, all)) {
      if (!one.style.visible)
        continue;
      const Shares shares = TRY(sharesOf(one.node->id, {}));
      for (std::size_t i = 0; i < pixels; ++i)
        if (shares[i] > m_most[i]) {
          m_most[i] = shares[i];
          m_seen[i] = one.node->id.value;
        }
    }
    return Unit{};
  }

  Result<LeaderVerdict> judge(const LeaderEnd& end) {
    LeaderVerdict verdict;
    const std::map<std::uint64_t, float> dot = dotAt(end.place, 1.0f);
    float others = 0.0f;
    for (const auto& [id, share] : dot) {
      if (id == end.structure.value) {
        verdict.own = share;
      } else if (id != 0) {
        others += share;
        verdict.another = std::max(verdict.another, share);
      }
      if (id != 0 && (!verdict.seen || share > dot.at(verdict.seen->value)))
        verdict.seen = model::NodeId{id};
    }
    // A line that runs under the dot's middle tells as much as a fill.
    const std::map<std::uint64_t, float> core = dotAt(end.place, 0.55f);
    if (const auto own = core.find(end.structure.value); own != core.end())
      verdict.own = std::max(verdict.own, own->second);
    bool seen = verdict.own >= enough || (verdict.own > 0.0f && verdict.own >= verdict.another);
    if (const float around = aroundDot(end);
        seen && around < (end.dashed ? plentyAround : leastAround)) {
      if (!end.dashed)
        verdict.fault = LeaderFault::underTheDot;
      else if (showsSomewhere(end.structure))
        verdict.fault = LeaderFault::dashedThoughSeen;
      return verdict;
    }
    const bool ground = others <= little;
    if (!seen && ground) {
      const float reached = TRY(reachedAt(end));
      seen = reached >= reaches;
    }
    if (seen)
      verdict.fault = end.dashed ? LeaderFault::dashedWhereSeen : LeaderFault::none;
    else if (!end.dashed)
      verdict.fault = ground ? LeaderFault::besideIt : LeaderFault::onAnother;
    else if (showsSomewhere(end.structure))
      verdict.fault = LeaderFault::dashedThoughSeen;
    return verdict;
  }

 private:
  Result<Image> drawn(model::NodeId id, model::Style look, const Colour& colour) const {
    look.colour = colour;
    look.inkColour = colour;
    std::vector<model::Node> nodes = m_picture.scene.nodes();
    for (model::Node& node : nodes)
      if (node.id == id) {
        if (look.gamma) {
          node.style.gamma = look.gamma;
          node.style.opacity = look.opacity;
        }
        node.style.colour = look.colour;
        node.style.inkColour = look.inkColour;
      }
    model::Scene scene = m_picture.scene;
    scene.setNodes(std::move(nodes));
    return m_draw(scene, m_picture.camera, m_picture.settings);
  }

  Result<Shares> sharesOf(model::NodeId id, const model::Style& look) const {
    const Result<Image> first = drawn(id, look, {255, 0, 255});
    const Result<Image> second = drawn(id, look, {0, 255, 0});
    if (!first.ok() || !second.ok())
      return first.ok() ? second.error() : first.error();
    Shares shares(std::size_t(m_width) * std::size_t(m_height));
    for (std::size_t i = 0; i < shares.size(); ++i) {
      int most = 0;
      for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
        most = std::max(most, std::abs(int(first->rgba[c]) - int(second->rgba[c])));
      shares[i] = std::uint8_t(most);
    }
    return shares;
  }

  /// Returns the share of a disc in the dot where each structure is what one sees; 0 is the ground.
  std::map<std::uint64_t, float> dotAt(const glm::vec2& place, float size) const {
    std::map<std::uint64_t, float> dot;
    float all = 0.0f;
    const float radius = size * m_picture.dotRadius;
    for (int y = int(place.y - radius); y <= int(place.y + radius); ++y)
      for (int x = int(place.x - radius); x <= int(place.x + radius); ++x) {
        const float dx = float(x) + 0.5f - place.x;
        const float dy = float(y) + 0.5f - place.y;
        if (dx * dx + dy * dy > radius * radius || x < 0 || y < 0 || x >= m_width || y >= m_height)
          continue;
        dot[m_seen[std::size_t(y) * std::size_t(m_width) + std::size_t(x)]] += 1.0f;
        all += 1.0f;
      }
    for (auto& [id, share] : dot)
      share /= std::max(all, 1.0f);
    return dot;
  }

  /// Returns how much of the structure one sees around the dot, in dots; plenty where nothing else
  /// is there that the dot could be on.
  float aroundDot(const LeaderEnd& end) const {
    float others = 0.0f;
    for (const auto& [id, share] : dotAt(end.place, near))
      others += id == 0 || id == end.structure.value ? 0.0f : share;
    if (others <= little)
      return plentyAround;
    const auto shows = [&](float size) {
      const std::map<std::uint64_t, float> disc = dotAt(end.place, size);
      const auto own = disc.find(end.structure.value);
      return own == disc.end() ? 0.0f : own->second * size * size;
    };
    return shows(near) - shows(haloed);
  }

  /// Returns how much of the structure's surface, drawn solid, would reach the eye there.
  Result<float> reachedAt(const LeaderEnd& end) {
    if (!m_solid.contains(end.structure.value)) {
      model::Style solid;
      solid.gamma = Gamma::clamped(5.0f);
      solid.opacity = Opacity::clamped(1.0f);
      Shares shares = TRY(sharesOf(end.structure, solid));
      m_solid[end.structure.value] = std::move(shares);
    }
    const int x = std::clamp(int(end.place.x), 0, m_width - 1);
    const int y = std::clamp(int(end.place.y), 0, m_height - 1);
    return float(m_solid[end.structure.value]
                        [std::size_t(y) * std::size_t(m_width) + std::size_t(x)]) /
           255.0f;
  }

  /// Tells whether there is a dot somewhere of which the structure takes most, and which does not
  /// cover what one sees of it.
  bool showsSomewhere(model::NodeId id) const {
    constexpr float most = 0.7f;
    const std::size_t row = std::size_t(m_width) + 1;
    std::vector<std::uint32_t> sums(row * (std::size_t(m_height) + 1));
    for (std::size_t y = 0; y < std::size_t(m_height); ++y)
      for (std::size_t x = 0; x < std::size_t(m_width); ++x)
        sums[(y + 1) * row + x + 1] = sums[y * row + x + 1] + sums[(y + 1) * row + x] -
                                      sums[y * row + x] +
                                      (m_seen[y * std::size_t(m_width) + x] == id.value ? 1 : 0);
    /// Returns the structure's pixels in a square about one.
    const auto within = [&](int x, int y, int half) {
      const auto left = std::size_t(std::max(x - half, 0));
      const auto top = std::size_t(std::max(y - half, 0));
      const auto right = std::size_t(std::min(x + half + 1, m_width));
      const auto foot = std::size_t(std::min(y + half + 1, m_height));
      return float(sums[foot * row + right] + sums[top * row + left] - sums[top * row + right] -
                   sums[foot * row + left]);
    };
    const float radius = m_picture.dotRadius;
    const int dot = std::max(int(std::ceil(radius - 0.5f)), 0);
    const auto side = float(2 * dot + 1);
    const int covered = int(std::ceil(haloed * radius));
    const int reach = int(near * radius);
    constexpr float disc = 3.14159265f;
    for (int y = dot; y + dot < m_height; ++y)
      for (int x = dot; x + dot < m_width; ++x)
        if (within(x, y, dot) >= most * side * side &&
            within(x, y, reach) - within(x, y, covered) >= plentyAround * disc * radius * radius)
          return true;
    return false;
  }

  const DrawPicture& m_draw;
  const JudgedPicture& m_picture;
  int m_width;
  int m_height;
  std::vector<std::uint64_t> m_seen;  ///< the structure that one sees; 0: ground
  std::vector<std::uint8_t> m_most;   ///< how much of it
  std::map<std::uint64_t, Shares> m_solid;
};

}  // namespace

Result<std::vector<LeaderVerdict>> judgeLeaders(const DrawPicture& draw,
                                                const JudgedPicture& picture,
                                                std::span<const LeaderEnd> ends) {
  Judge judge(draw, picture);
  TRY(judge.look());
  std::vector<LeaderVerdict> verdicts;
  for (const LeaderEnd& end : ends) {
    const LeaderVerdict verdict = TRY(judge.judge(end));
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace sline::render
