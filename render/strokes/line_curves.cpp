// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
  std::vector<std::uint32_t> segments;  ///< of each piece between two samples
  std::vector<glm::vec2> pixels;
  float step = 1.0f;  ///< px
  bool closed = false;

  void clear() {
    samples.clear();
    segments.clear();
    pixels.clear();
  }
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
        m_up(view.toPatient({0.0f, 1.0f, 0.0f})),
        m_back(view.toPatient({0.0f, 0.0f, 1.0f})) {}

  void add(std::span<const Chains::Link> given, std::vector<Segment>& out) {
    takeFromTop(given);
    if (!measure()) {
      addPlain(out);
      return;
    }
    if (sample()) {
      findMoves();
      findPressures();
    } else {
      takeEnds();
    }
    join(out);
  }

 private:
  /// Gives each sample its move and the pressure there.
  void findPressures() {
    const float unit = m_view.outputUnit();
    const float whole = m_line.step * float(m_line.segments.size()) / unit;
    const float reach = m_line.closed ? 0.0f : std::min(taperReach, whole / 3.0f);
    for (std::size_t i = 0; i < m_line.samples.size(); ++i) {
      const Sample& s = m_line.samples[i];
      if (m_settings.waver > 0.0f)
        m_moves[i] += waverAt(s.place);
      const std::size_t fromEnd = std::min(i, m_line.samples.size() - 1 - i);
      m_pressures[i] = m_pressure.at(s, m_outwards[i], m_line.step * float(fromEnd) / unit, reach);
    }
  }

  /// Makes a line of too few pixels for a curve of its segments' ends.
  void takeEnds() {
    for (std::size_t i = 0; i <= m_links.size(); ++i) {
      const Chains::Link& link = m_links[std::min(i, m_links.size() - 1)];
      addSample(mixed(m_segments[link.segment], link.reversed, i == m_links.size() ? 1.0f : 0.0f));
      if (i < m_links.size())
        m_line.segments.push_back(link.segment);
    }
  }

  /// Appends the pieces of the curve, as few as the joints' limits allow.
  void join(std::vector<Segment>& out) {
    const std::size_t last = m_line.samples.size() - 1;
    const bool up = risesToItsEnd();
    m_points.clear();
    for (std::size_t i = 0; i <= last; ++i)
      m_points.push_back(jointPoint(up ? last - i : i));
    const auto concave = [&](std::size_t i) {
      return m_segments[m_line.segments[up ? last - 1 - i : i]].concave;
    };
    m_stops.assign(1, 0);
    while (m_stops.back() < last) {
      // Concave parts of an outline and others stay apart.
      const std::size_t first = m_stops.back();
      std::size_t end = first + 1;
      while (end < last && concave(end) == concave(first))
        ++end;
      while (m_stops.back() < end)
        m_stops.push_back(
            farthestJoint(std::span(m_points).first(end + 1), m_stops.back(), m_settings.joints));
    }
    if (up)
      for (std::size_t i = m_stops.size() - 1; i > 0; --i)
        out.push_back(piece(last - m_stops[i], last - m_stops[i - 1]));
    else
      for (std::size_t i = 1; i < m_stops.size(); ++i)
        out.push_back(piece(m_stops[i - 1], m_stops[i]));
  }

  /// Tells whether the line's end lies higher in the patient than its beginning, for a closed line
  /// the point before its top than the one after: joints are made downwards, alike in a mirrored
  /// body.
  bool risesToItsEnd() const {
    const std::vector<Sample>& all = m_line.samples;
    const std::size_t inset = m_line.closed ? 1 : 0;
    const glm::vec3& first = all[inset].place;
    const glm::vec3& last = all[all.size() - 1 - inset].place;
    return std::pair(last.z, last.y) > std::pair(first.z, first.y);
  }

  JointPoint jointPoint(std::size_t i) const {
    const Sample& s = m_line.samples[i];
    const float width = m_settings.pen * m_pressures[i];
    return {.drawn =
                m_line.pixels[i] + m_moves[i] + std::max(0.5f * width - 0.5f, 0.0f) * m_outwards[i],
            .line = m_line.pixels[i],
            .depth = -glm::dot(s.place, m_back),
            .width = width,
            .opacity = s.opacity,
            .entry = s.entry};
  }

  Segment piece(std::size_t from, std::size_t to) const {
    const Sample& a = m_line.samples[from];
    const Sample& b = m_line.samples[to];
    const Segment& first = m_segments[m_line.segments[from]];
    return {.a = a.place,
            .b = b.place,
            .normalA = a.normal,
            .normalB = b.normal,
            .opacityA = a.opacity,
            .opacityB = b.opacity,
            .entryA = a.entry,
            .entryB = b.entry,
            .gammaA = a.gamma,
            .gammaB = b.gamma,
            .moveA = shift(from),
            .moveB = shift(to),
            .pressureA = m_pressures[from],
            .pressureB = m_pressures[to],
            .triangle = first.triangle,
            .concave = first.concave};
  }

  /// Returns the move of a sample in the patient, mm.
  glm::vec3 shift(std::size_t i) const {
    return m_view.millimetresPerPixel(m_line.samples[i].place) *
           (m_moves[i].x * m_right + m_moves[i].y * m_up);
  }

  /// Appends the line as it is.
  void addPlain(std::vector<Segment>& out) const {
    const Chains one{.links = m_links, .first = {0, std::uint32_t(m_links.size())}};
    const std::vector<Segment> plain =
        simplified(m_segments, one, m_settings.joints.drawn * m_settings.pixel,
                   m_settings.joints.longest * m_settings.pixel);
    out.insert(out.end(), plain.begin(), plain.end());
  }

  const glm::vec3& startOf(const Chains::Link& link) const {
    const Segment& s = m_segments[link.segment];
    return link.reversed ? s.b : s.a;
  }

  /// Takes the links, those of a closed line from its highest point in the patient: its samples
  /// then move with it while the scene turns, and lie alike in a mirrored body.
  void takeFromTop(std::span<const Chains::Link> given) {
    m_links.assign(given.begin(), given.end());
    m_line.clear();
    m_moves.clear();
    m_pressures.clear();
    m_outwards.clear();
    const Segment& last = m_segments[m_links.back().segment];
    m_line.closed = m_links.size() > 2 &&
                    startOf(m_links.front()) == (m_links.back().reversed ? last.a : last.b);
    if (!m_line.closed)
      return;
    const auto top = std::max_element(m_links.begin(), m_links.end(), [this](auto& a, auto& b) {
      return std::pair(startOf(a).z, startOf(a).y) < std::pair(startOf(b).z, startOf(b).y);
    });
    std::rotate(m_links.begin(), top, m_links.end());
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

  /// Measures how far along the line in the picture its links end. Returns false where the line
  /// reaches behind the eye or is far too long for a curve.
  bool measure() {
    m_ends.assign(1, 0.0f);
    glm::vec2 before{0.0f};
    for (std::size_t i = 0; i <= m_links.size(); ++i) {
      const Chains::Link& link = m_links[std::min(i, m_links.size() - 1)];
      const Segment& s = m_segments[link.segment];
      const auto point = m_view.project((i == m_links.size()) != link.reversed ? s.b : s.a);
      if (!(point.w > 0.0f))
        return false;
      if (i > 0)
        m_ends.push_back(m_ends.back() + glm::distance(point.pixel, before));
      before = point.pixel;
    }
    return m_ends.back() < mostSamples * wantedStep();
  }

  float wantedStep() const { return std::max(sampleStep * m_view.outputUnit(), 1.0f); }

  void addSample(const Sample& s) {
    m_line.samples.push_back(s);
    m_line.pixels.push_back(m_view.project(s.place).pixel);
    m_moves.emplace_back(0.0f);
    m_pressures.push_back(1.0f);
    m_outwards.push_back(outwardAt(s));
  }

  /// Returns false where the line has too few points to be a curve.
  bool sample() {
    const float length = m_ends.back();
    const float wanted = wantedStep();
    if (!(length > 2.0f * wanted))
      return false;
    const auto pieces = std::size_t(std::lround(length / wanted));
    m_line.step = length / float(pieces);
    std::size_t at = 0;
    for (std::size_t k = 0; k <= pieces; ++k) {
      const float way = k == pieces ? length : m_line.step * float(k);
      while (at + 1 < m_links.size() && m_ends[at + 1] <= way)
        ++at;
      const float span = m_ends[at + 1] - m_ends[at];
      const float t = k == pieces ? 1.0f : span > 0.0f ? (way - m_ends[at]) / span : 0.0f;
      Sample s = mixed(m_segments[m_links[at].segment], m_links[at].reversed, t);
      s.normal = glm::normalize(s.normal);
      addSample(s);
      if (k < pieces)
        m_line.segments.push_back(m_links[at].segment);
    }
    return true;
  }

  /// Finds how far the curve lies from each sample, px.
  void findMoves() {
    const float unit = m_view.outputUnit();
    const float deviation = m_settings.smoothing * widestAverage * unit / m_line.step;
    if (!(deviation > 0.3f))
      return;
    std::vector<glm::vec2>& points = m_flat;
    points = m_line.pixels;
    if (m_line.closed)
      points.pop_back();
    m_once = points;
    blur(m_once, cornerAverage * unit / m_line.step, m_line.closed);
    const int arm = std::max(2, int(std::lround(cornerArm * unit / m_line.step)));
    std::vector<std::size_t> fixed = corners(m_once, arm, m_line.closed);
    if (m_line.closed && fixed.empty()) {
      average(points, deviation, true);
      std::copy(m_rest.begin(), m_rest.end(), m_moves.begin());
      m_moves.back() = m_moves.front();
    } else {
      if (m_line.closed) {
        // Between its corners a closed line is as good as open; the first piece wraps around.
        fixed.push_back(fixed.front() + points.size());
      } else {
        fixed.insert(fixed.begin(), 0);
        fixed.push_back(points.size() - 1);
      }
      for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
        m_piece.clear();
        for (std::size_t k = fixed[i]; k <= fixed[i + 1]; ++k)
          m_piece.push_back(points[k % points.size()]);
        average(m_piece, deviation, false);
        for (std::size_t k = 0; k < m_rest.size(); ++k)
          m_moves[(fixed[i] + k) % points.size()] = m_rest[k];
      }
      if (m_line.closed)
        m_moves.back() = m_moves.front();
    }
    bound(int(std::lround(deviation)));
  }

  /// Leaves in `m_rest` how far each point moves when the points are averaged.
  void average(const std::vector<glm::vec2>& points, float deviation, bool closed) {
    m_once = points;
    blur(m_once, deviation, closed);
    m_rest.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      m_rest[i] = points[i] - m_once[i];
    blur(m_rest, deviation, closed);
    for (std::size_t i = 0; i < points.size(); ++i)
      m_rest[i] = m_once[i] + m_rest[i] - points[i];
  }

  /// Holds the moves to the bounds.
  void bound(int reach) {
    const float unit = m_view.outputUnit();
    const float inwards =
        std::clamp(m_settings.pen - coveredEdge * unit, 0.3f * unit, curveBound * unit);
    std::vector<float> shares(m_moves.size(), 1.0f);
    for (std::size_t i = 0; i < m_moves.size(); ++i) {
      const float length = glm::length(m_moves[i]);
      float share = length > curveBound * unit ? curveBound * unit / length : 1.0f;
      if (m_settings.outline) {
        const float out = glm::dot(m_moves[i], m_outwards[i]);
        const float most = out > 0.0f ? outlineBound * unit : inwards;
        if (std::abs(out) > most)
          share = std::min(share, most / std::abs(out));
      }
      shares[i] = share;
    }
    shares = softMinimum(shares, std::max(reach, 1), m_line.closed);
    for (std::size_t i = 0; i < m_moves.size(); ++i)
      m_moves[i] *= shares[i];
  }

  const std::vector<Segment>& m_segments;
  const PictureView& m_view;
  const CurveSettings& m_settings;
  Pressure m_pressure;
  glm::vec3 m_right;
  glm::vec3 m_up;
  glm::vec3 m_back;
  // Of the line in work, kept from one to the next so that they need not be allocated again.
  std::vector<Chains::Link> m_links;
  std::vector<float> m_ends;  ///< of the links, px from the line's beginning
  SampledLine m_line;
  std::vector<glm::vec2> m_moves;     ///< of the samples, px
  std::vector<float> m_pressures;     ///< of the samples
  std::vector<glm::vec2> m_outwards;  ///< of an outline's samples; zeros elsewhere
  std::vector<glm::vec2> m_flat;
  std::vector<glm::vec2> m_piece;
  std::vector<glm::vec2> m_once;
  std::vector<glm::vec2> m_rest;
  std::vector<JointPoint> m_points;
  std::vector<std::size_t> m_stops;  ///< points between which the pieces lie
};

}  // namespace

std::vector<Segment> curved(const std::vector<Segment>& segments, const Chains& chains,
                            const PictureView& view, const CurveSettings& settings) {
  const std::size_t blocks = (chains.count() + chainsAtOnce - 1) / chainsAtOnce;
  std::vector<std::vector<Segment>> parts(blocks);
  parallelFor(blocks, 1, [&](std::size_t block) {
    CurveMaker maker(segments, view, settings);
    const std::size_t end = std::min(chains.count(), (block + 1) * chainsAtOnce);
    for (std::size_t chain = block * chainsAtOnce; chain < end; ++chain)
      maker.add(std::span(chains.links)
                    .subspan(chains.first[chain], chains.first[chain + 1] - chains.first[chain]),
                parts[block]);
  });
  if (blocks == 1)
    return std::move(parts.front());
  std::size_t count = 0;
  for (const std::vector<Segment>& part : parts)
    count += part.size();
  std::vector<Segment> out;
  out.reserve(count);
  for (const std::vector<Segment>& part : parts)
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
