// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/parallel.h"
#include "render/strokes/polyline_filter.h"

namespace sline::render {

namespace {

// Lengths in λ.
constexpr float sampleStep = 0.5f;
constexpr float widestAverage = 3.0f;
constexpr float cornerArm = 4.0f;
constexpr float cornerAverage = 1.0f;
constexpr float taperReach = 6.0f;
constexpr float waverLength = 18.0f;
// Longer lines, as the eye sees them from within a surface, stay as they are.
constexpr float mostSamples = 20000.0f;
// An outline's ink covers at least this much of what lies within it.
constexpr float coveredEdge = 0.4f;
// Pressures (METHOD §11.4).
constexpr float leastTip = 0.3f;
constexpr float lightShare = 0.25f;
constexpr float nearest = 1.1f;
constexpr float farthest = 0.85f;
// Chains that are worked on together.
constexpr std::size_t chainsAtOnce = 64;

/// A point of a line with everything that a segment's end says.
struct Sample {
  glm::vec3 place;
  glm::vec3 normal;
  float opacity;
  float entry;
  float gamma;
};

Sample mixed(const Segment& s, bool reversed, float t) {
  const float u = reversed ? 1.0f - t : t;
  // The ends themselves are exact, as neighbours share them.
  if (u <= 0.0f)
    return {s.a, s.normalA, s.opacityA, s.entryA, s.gammaA};
  if (u >= 1.0f)
    return {s.b, s.normalB, s.opacityB, s.entryB, s.gammaB};
  return {glm::mix(s.a, s.b, u), glm::mix(s.normalA, s.normalB, u),
          glm::mix(s.opacityA, s.opacityB, u), glm::mix(s.entryA, s.entryB, u),
          glm::mix(s.gammaA, s.gammaB, u)};
}

/// One chain, sampled at even distances of the picture.
struct SampledLine {
  std::vector<Sample> samples;
  std::vector<std::size_t> segments;  ///< of each piece between two samples
  std::vector<glm::vec2> pixels;
  float step = 1.0f;  ///< px
  bool closed = false;
};

/// Knows what a point's place in the scene does to the pen.
class Pressure {
 public:
  Pressure(const PictureView& view, const CurveSettings& settings)
      : m_settings(settings),
        m_light(settings.light.x, settings.light.y),
        m_back(view.toPatient({0.0f, 0.0f, 1.0f})) {
    for (const glm::vec3& corner : view.bounds().corners()) {
      m_low = std::min(m_low, -glm::dot(corner, m_back));
      m_high = std::max(m_high, -glm::dot(corner, m_back));
    }
  }

  /// Returns the pressure at a point so many λ from the line's nearest end.
  float at(const Sample& sample, const glm::vec2& outward, float fromEnd, float reach) const {
    const float depth = (-glm::dot(sample.place, m_back) - m_low) / std::max(m_high - m_low, 1e-6f);
    float full = glm::mix(nearest, farthest, std::clamp(depth, 0.0f, 1.0f));
    if (m_settings.outline)
      full *= 1.0f - lightShare * glm::dot(outward, m_light);
    else
      full *= (0.35f + 0.4f * sample.opacity) / (0.45f + 0.55f * sample.opacity);
    const float t = reach > 0.0f ? std::clamp(fromEnd / reach, 0.0f, 1.0f) : 1.0f;
    full *= glm::mix(leastTip, 1.0f, t * t * (3.0f - 2.0f * t));
    return glm::mix(1.0f, full, m_settings.variation);
  }

 private:
  const CurveSettings& m_settings;
  glm::vec2 m_light;
  glm::vec3 m_back;
  float m_low = std::numeric_limits<float>::infinity();
  float m_high = -std::numeric_limits<float>::infinity();
};

class CurveMaker {
 public:
  CurveMaker(const std::vector<Segment>& segments, const PictureView& view,
             const CurveSettings& settings)
      : m_segments(segments),
        m_view(view),
        m_settings(settings),
        m_pressure(view, settings),
        m_right(view.toPatient({1.0f, 0.0f, 0.0f})),
        m_up(view.toPatient({0.0f, 1.0f, 0.0f})) {}

  void add(std::span<const Chains::Link> given, std::vector<Segment>& out) const {
    const std::vector<Chains::Link> links = fromTop(given);
    SampledLine line;
    if (!sample(links, line)) {
      for (const Chains::Link& link : links)
        out.push_back(turned(m_segments[link.segment], link.reversed));
      return;
    }
    std::vector<glm::vec2> moves = movesOf(line);
    if (m_settings.waver > 0.0f)
      for (std::size_t i = 0; i < moves.size(); ++i)
        moves[i] += waverAt(line.samples[i].place);
    const float unit = m_view.outputUnit();
    const float whole = line.step * float(line.segments.size()) / unit;
    const float reach = line.closed ? 0.0f : std::min(taperReach, whole / 3.0f);
    std::vector<glm::vec3> shift(line.samples.size());
    std::vector<float> pressure(line.samples.size());
    for (std::size_t i = 0; i < line.samples.size(); ++i) {
      const Sample& s = line.samples[i];
      const float mm = m_view.millimetresPerPixel(s.place);
      shift[i] = mm * (moves[i].x * m_right + moves[i].y * m_up);
      const std::size_t fromEnd = std::min(i, line.samples.size() - 1 - i);
      pressure[i] = m_pressure.at(s, outwardAt(s), line.step * float(fromEnd) / unit, reach);
    }
    for (std::size_t i = 0; i + 1 < line.samples.size(); ++i) {
      const Sample& a = line.samples[i];
      const Sample& b = line.samples[i + 1];
      const Segment& from = m_segments[line.segments[i]];
      out.push_back({.a = a.place,
                     .b = b.place,
                     .normalA = a.normal,
                     .normalB = b.normal,
                     .opacityA = a.opacity,
                     .opacityB = b.opacity,
                     .entryA = a.entry,
                     .entryB = b.entry,
                     .gammaA = a.gamma,
                     .gammaB = b.gamma,
                     .moveA = shift[i],
                     .moveB = shift[i + 1],
                     .pressureA = pressure[i],
                     .pressureB = pressure[i + 1],
                     .triangle = from.triangle,
                     .concave = from.concave});
    }
  }

 private:
  static Segment turned(const Segment& s, bool reversed) {
    Segment t = s;
    if (reversed) {
      std::swap(t.a, t.b);
      std::swap(t.normalA, t.normalB);
      std::swap(t.opacityA, t.opacityB);
      std::swap(t.entryA, t.entryB);
      std::swap(t.gammaA, t.gammaB);
    }
    return t;
  }

  const glm::vec3& startOf(const Chains::Link& link) const {
    const Segment& s = m_segments[link.segment];
    return link.reversed ? s.b : s.a;
  }

  /// Returns the links, those of a closed line from its highest point in the patient: its samples
  /// then move with it while the scene turns, and lie alike in a mirrored body.
  std::vector<Chains::Link> fromTop(std::span<const Chains::Link> given) const {
    std::vector<Chains::Link> links(given.begin(), given.end());
    const Segment& last = m_segments[links.back().segment];
    if (links.size() < 3 || startOf(links.front()) != (links.back().reversed ? last.a : last.b))
      return links;
    const auto top = std::max_element(links.begin(), links.end(), [this](auto& a, auto& b) {
      return std::pair(startOf(a).z, startOf(a).y) < std::pair(startOf(b).z, startOf(b).y);
    });
    std::rotate(links.begin(), top, links.end());
    return links;
  }

  glm::vec2 outwardAt(const Sample& s) const {
    return m_settings.outline ? m_view.projectedDirection(s.place, s.normal) : glm::vec2(0.0f);
  }

  /// Returns how far a hand is off at a place: waves that stay with the place while the scene
  /// turns.
  glm::vec2 waverAt(const glm::vec3& place) const {
    const float wave = waverLength * m_view.outputUnit() * m_view.millimetresPerPixel(place);
    const glm::vec3 p = place / std::max(wave, 1e-6f);
    return 0.5f * m_settings.waver *
           glm::vec2(std::sin(6.3f * p.x + 2.1f * p.y) + std::sin(3.7f * p.z - 2.9f * p.y + 1.0f),
                     std::sin(5.9f * p.z + 1.7f * p.x + 2.0f) + std::sin(4.1f * p.y - 3.3f * p.x));
  }

  /// Returns false where the line has too few points to be a curve or far too many, or reaches
  /// behind the eye.
  bool sample(std::span<const Chains::Link> links, SampledLine& line) const {
    std::vector<float> ends{0.0f};
    glm::vec2 before{0.0f};
    for (std::size_t i = 0; i <= links.size(); ++i) {
      const Chains::Link& link = links[std::min(i, links.size() - 1)];
      const Segment& s = m_segments[link.segment];
      const auto point = m_view.project((i == links.size()) != link.reversed ? s.b : s.a);
      if (!(point.w > 0.0f))
        return false;
      if (i > 0)
        ends.push_back(ends.back() + glm::distance(point.pixel, before));
      before = point.pixel;
    }
    const float length = ends.back();
    const float wanted = std::max(sampleStep * m_view.outputUnit(), 1.0f);
    if (!(length > 2.0f * wanted) || !(length < mostSamples * wanted))
      return false;
    const auto pieces = std::size_t(std::lround(length / wanted));
    line.step = length / float(pieces);
    const Segment& first = m_segments[links.front().segment];
    const Segment& last = m_segments[links.back().segment];
    line.closed = links.size() > 2 && (links.front().reversed ? first.b : first.a) ==
                                          (links.back().reversed ? last.a : last.b);
    std::size_t at = 0;
    for (std::size_t k = 0; k <= pieces; ++k) {
      const float way = k == pieces ? length : line.step * float(k);
      while (at + 1 < links.size() && ends[at + 1] <= way)
        ++at;
      const float span = ends[at + 1] - ends[at];
      const float t = k == pieces ? 1.0f : span > 0.0f ? (way - ends[at]) / span : 0.0f;
      Sample s = mixed(m_segments[links[at].segment], links[at].reversed, t);
      s.normal = glm::normalize(s.normal);
      line.samples.push_back(s);
      line.pixels.push_back(m_view.project(s.place).pixel);
      if (k < pieces)
        line.segments.push_back(links[at].segment);
    }
    return true;
  }

  /// Returns how far the curve lies from each sample, px.
  std::vector<glm::vec2> movesOf(const SampledLine& line) const {
    const std::size_t count = line.pixels.size();
    std::vector<glm::vec2> moves(count, glm::vec2(0.0f));
    const float unit = m_view.outputUnit();
    const float deviation = m_settings.smoothing * widestAverage * unit / line.step;
    if (!(deviation > 0.3f))
      return moves;
    std::vector<glm::vec2> points = line.pixels;
    if (line.closed)
      points.pop_back();
    std::vector<glm::vec2> even = points;
    blur(even, cornerAverage * unit / line.step, line.closed);
    const int arm = std::max(2, int(std::lround(cornerArm * unit / line.step)));
    std::vector<std::size_t> fixed = corners(even, arm, line.closed);
    if (line.closed && fixed.empty()) {
      moves = averaged(points, deviation, true);
      moves.push_back(moves.front());
    } else {
      if (line.closed) {
        // Between its corners a closed line is as good as open; the first piece wraps around.
        fixed.push_back(fixed.front() + points.size());
      } else {
        fixed.insert(fixed.begin(), 0);
        fixed.push_back(points.size() - 1);
      }
      for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
        std::vector<glm::vec2> piece;
        for (std::size_t k = fixed[i]; k <= fixed[i + 1]; ++k)
          piece.push_back(points[k % points.size()]);
        const std::vector<glm::vec2> moved = averaged(piece, deviation, false);
        for (std::size_t k = 0; k < moved.size(); ++k)
          moves[(fixed[i] + k) % points.size()] = moved[k];
      }
      if (line.closed)
        moves.back() = moves.front();
    }
    return bounded(line, std::move(moves), int(std::lround(deviation)));
  }

  static std::vector<glm::vec2> averaged(const std::vector<glm::vec2>& points, float deviation,
                                         bool closed) {
    std::vector<glm::vec2> once = points;
    blur(once, deviation, closed);
    std::vector<glm::vec2> rest(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      rest[i] = points[i] - once[i];
    blur(rest, deviation, closed);
    std::vector<glm::vec2> moves(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      moves[i] = once[i] + rest[i] - points[i];
    return moves;
  }

  std::vector<glm::vec2> bounded(const SampledLine& line, std::vector<glm::vec2> moves,
                                 int reach) const {
    const float unit = m_view.outputUnit();
    const float inwards =
        std::clamp(m_settings.pen - coveredEdge * unit, 0.3f * unit, curveBound * unit);
    std::vector<float> shares(moves.size(), 1.0f);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const float length = glm::length(moves[i]);
      float share = length > curveBound * unit ? curveBound * unit / length : 1.0f;
      if (m_settings.outline) {
        const float out = glm::dot(moves[i], outwardAt(line.samples[i]));
        const float most = out > 0.0f ? outlineBound * unit : inwards;
        if (std::abs(out) > most)
          share = std::min(share, most / std::abs(out));
      }
      shares[i] = share;
    }
    shares = softMinimum(shares, std::max(reach, 1), line.closed);
    for (std::size_t i = 0; i < moves.size(); ++i)
      moves[i] *= shares[i];
    return moves;
  }

  const std::vector<Segment>& m_segments;
  const PictureView& m_view;
  const CurveSettings& m_settings;
  Pressure m_pressure;
  glm::vec3 m_right;
  glm::vec3 m_up;
};

}  // namespace

std::vector<Segment> curved(const std::vector<Segment>& segments, const Chains& chains,
                            const PictureView& view, const CurveSettings& settings) {
  const CurveMaker maker(segments, view, settings);
  const std::size_t blocks = (chains.count() + chainsAtOnce - 1) / chainsAtOnce;
  std::vector<std::vector<Segment>> parts(blocks);
  parallelFor(blocks, 1, [&](std::size_t block) {
    const std::size_t end = std::min(chains.count(), (block + 1) * chainsAtOnce);
    for (std::size_t chain = block * chainsAtOnce; chain < end; ++chain)
      maker.add(std::span(chains.links)
                    .subspan(chains.first[chain], chains.first[chain + 1] - chains.first[chain]),
                parts[block]);
  });
  std::vector<Segment> out;
  for (std::vector<Segment>& part : parts)
    out.insert(out.end(), part.begin(), part.end());
  return out;
}

std::vector<float> lengthsInPicture(const Chains& chains, const std::vector<Segment>& segments,
                                    const PictureView& view) {
  std::vector<float> lengths(chains.count(), 0.0f);
  for (std::size_t chain = 0; chain < chains.count(); ++chain)
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
      const Segment& s = segments[chains.links[i].segment];
      lengths[chain] += glm::distance(view.project(s.a).pixel, view.project(s.b).pixel);
    }
  return lengths;
}

}  // namespace sline::render
