// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/parallel.h"
#include "render/sight/rules.h"
#include "render/strokes/curve_samples.h"
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
// Chains that are worked on together.
constexpr std::size_t chainsAtOnce = 64;

// Segments lie about as clusters give them: the processor fetches them so many links early.
constexpr std::size_t linksAhead = 6;

void fetch(const Segment& segment) {
  __builtin_prefetch(&segment);
  __builtin_prefetch(&segment.gammaB);
}

class CurveMaker {
 public:
  CurveMaker(const std::vector<Segment>& segments, const PictureView& view,
             const CurveSettings& settings)
      : m_segments(segments),
        m_view(view),
        m_settings(settings),
        m_pressure(view, settings.light, settings.outline, settings.variation),
        m_right(view.toPatient({1.0f, 0.0f, 0.0f})),
        m_up(view.toPatient({0.0f, 1.0f, 0.0f})),
        m_back(view.toPatient({0.0f, 0.0f, 1.0f})) {}

  void add(std::span<const Chains::Link> given, std::span<const ChainPoints::Point> points,
           std::vector<Segment>& out) {
    takeFromTop(given, points);
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
  /// Gives each sample the pressure there, and its move to where a hand is off.
  void findPressures() {
    const float unit = m_view.outputUnit();
    const float whole = m_line.step * float(m_line.segments.size()) / unit;
    const float reach = m_line.closed ? 0.0f : std::min(taperReach, whole / 3.0f);
    m_line.findPressures(m_pressure, reach, unit);
    if (!(m_settings.waver > 0.0f))
      return;
    for (std::size_t i = 0; i < m_line.size(); ++i) {
      const glm::vec2 waver = waverAt(m_line.placeOf(i));
      m_line.move[0][i] += waver.x;
      m_line.move[1][i] += waver.y;
    }
  }

  /// Makes a line of too few pixels for a curve of its segments' ends.
  void takeEnds() {
    m_line.start(m_links.size() + 1);
    for (std::size_t i = 0; i <= m_links.size(); ++i) {
      const Chains::Link& link = m_links[std::min(i, m_links.size() - 1)];
      m_line.set(i, m_segments[link.segment], link.reversed, i == m_links.size() ? 1.0f : 0.0f);
      if (i < m_links.size())
        m_line.setPiece(i, link.segment, m_segments[link.segment]);
    }
    m_line.project(m_view, m_settings.outline);
  }

  /// Appends the pieces of the curve, as few as the joints' limits allow.
  void join(std::vector<Segment>& out) {
    const std::size_t last = m_line.size() - 1;
    const bool up = risesToItsEnd();
    m_points.resize(last + 1);
    for (std::size_t i = 0; i <= last; ++i)
      m_points[i] = jointPoint(up ? last - i : i);
    const auto concave = [&](std::size_t i) { return m_line.concave[up ? last - 1 - i : i]; };
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
    const std::size_t inset = m_line.closed ? 1 : 0;
    const glm::vec3 first = m_line.placeOf(inset);
    const glm::vec3 last = m_line.placeOf(m_line.size() - 1 - inset);
    return std::pair(last.z, last.y) > std::pair(first.z, first.y);
  }

  JointPoint jointPoint(std::size_t i) const {
    const float width = m_settings.pen * m_line.pressure[i];
    const glm::vec2 pixel = m_line.pixelOf(i);
    return {
        .drawn = pixel + m_line.moveOf(i) + rule::penOutside(0.5f * width) * m_line.outwardOf(i),
        .line = pixel,
        .depth = -glm::dot(m_line.placeOf(i), m_back),
        .width = width,
        .opacity = m_line.opacity[i],
        .entry = m_line.entry[i]};
  }

  Segment piece(std::size_t from, std::size_t to) const {
    const Segment& first = m_segments[m_line.segments[from]];
    return {.a = m_line.placeOf(from),
            .b = m_line.placeOf(to),
            .normalA = m_line.normalOf(from),
            .normalB = m_line.normalOf(to),
            .opacityA = m_line.opacity[from],
            .opacityB = m_line.opacity[to],
            .entryA = m_line.entry[from],
            .entryB = m_line.entry[to],
            .gammaA = m_line.gamma[from],
            .gammaB = m_line.gamma[to],
            .moveA = shift(from),
            .moveB = shift(to),
            .pressureA = m_line.pressure[from],
            .pressureB = m_line.pressure[to],
            .triangle = first.triangle,
            .concave = first.concave};
  }

  /// Returns the move of a sample in the patient, mm.
  glm::vec3 shift(std::size_t i) const {
    return m_view.millimetresPerPixel(m_line.placeOf(i)) *
           (m_line.move[0][i] * m_right + m_line.move[1][i] * m_up);
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
  void takeFromTop(std::span<const Chains::Link> given,
                   std::span<const ChainPoints::Point> points) {
    m_links.assign(given.begin(), given.end());
    m_ends.assign(points.begin(), points.end());
    const Segment& last = m_segments[m_links.back().segment];
    m_line.closed = m_links.size() > 2 &&
                    startOf(m_links.front()) == (m_links.back().reversed ? last.a : last.b);
    if (!m_line.closed)
      return;
    const auto top = std::max_element(m_links.begin(), m_links.end(), [this](auto& a, auto& b) {
      return std::pair(startOf(a).z, startOf(a).y) < std::pair(startOf(b).z, startOf(b).y);
    });
    const auto way = top - m_links.begin();
    std::rotate(m_links.begin(), top, m_links.end());
    // The last point is the first one again.
    m_ends.pop_back();
    std::rotate(m_ends.begin(), m_ends.begin() + way, m_ends.end());
    m_ends.push_back(m_ends.front());
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
    m_ways.assign(1, 0.0f);
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
      if (!(m_ends[i].w > 0.0f))
        return false;
      if (i > 0)
        m_ways.push_back(m_ways.back() + glm::distance(m_ends[i].pixel, m_ends[i - 1].pixel));
    }
    return m_ways.back() < mostSamples * wantedStep();
  }

  float wantedStep() const { return std::max(sampleStep * m_view.outputUnit(), 1.0f); }

  /// Returns false where the line has too few points to be a curve.
  bool sample() {
    const float length = m_ways.back();
    const float wanted = wantedStep();
    if (!(length > 2.0f * wanted))
      return false;
    const auto pieces = std::size_t(std::lround(length / wanted));
    m_line.step = length / float(pieces);
    m_line.start(pieces + 1);
    std::size_t at = 0;
    for (std::size_t k = 0; k <= pieces; ++k) {
      const float way = k == pieces ? length : m_line.step * float(k);
      while (at + 1 < m_links.size() && m_ways[at + 1] <= way) {
        ++at;
        fetch(m_segments[m_links[std::min(at + linksAhead, m_links.size() - 1)].segment]);
      }
      const float span = m_ways[at + 1] - m_ways[at];
      const float t = k == pieces ? 1.0f : span > 0.0f ? (way - m_ways[at]) / span : 0.0f;
      const Segment& segment = m_segments[m_links[at].segment];
      m_line.set(k, segment, m_links[at].reversed, t);
      if (k < pieces)
        m_line.setPiece(k, m_links[at].segment, segment);
    }
    m_line.normalise();
    m_line.project(m_view, m_settings.outline);
    return true;
  }

  /// Finds how far the curve lies from each sample, px.
  void findMoves() {
    const float unit = m_view.outputUnit();
    const float deviation = m_settings.smoothing * widestAverage * unit / m_line.step;
    if (!(deviation > 0.3f))
      return;
    std::vector<glm::vec2>& points = m_flat;
    points.resize(m_line.size());
    // Sums lose less where they begin near zero.
    const glm::vec2 origin = m_line.pixelOf(0);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = m_line.pixelOf(i) - origin;
    if (m_line.closed)
      points.pop_back();
    m_once = points;
    m_filter.blur(m_once, cornerAverage * unit / m_line.step, m_line.closed);
    const int arm = std::max(2, int(std::lround(cornerArm * unit / m_line.step)));
    std::vector<std::size_t> fixed = m_filter.corners(m_once, arm, m_line.closed);
    if (m_line.closed && fixed.empty()) {
      average(points, deviation, true);
      for (std::size_t i = 0; i < points.size(); ++i)
        setMove(i, m_rest[i]);
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
          setMove((fixed[i] + k) % points.size(), m_rest[k]);
      }
    }
    if (m_line.closed)
      setMove(m_line.size() - 1, m_line.moveOf(0));
    bound(int(std::lround(deviation)));
  }

  void setMove(std::size_t i, const glm::vec2& move) {
    m_line.move[0][i] = move.x;
    m_line.move[1][i] = move.y;
  }

  /// Leaves in `m_rest` how far each point moves when the points are averaged.
  void average(const std::vector<glm::vec2>& points, float deviation, bool closed) {
    m_once = points;
    m_filter.blur(m_once, deviation, closed);
    m_rest.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      m_rest[i] = points[i] - m_once[i];
    m_filter.blur(m_rest, deviation, closed);
    for (std::size_t i = 0; i < points.size(); ++i)
      m_rest[i] = m_once[i] + m_rest[i] - points[i];
  }

  /// Holds the moves to the bounds.
  void bound(int reach) {
    const float unit = m_view.outputUnit();
    const float inwards =
        std::clamp(m_settings.pen - coveredEdge * unit, 0.3f * unit, curveBound * unit);
    if (!m_line.findShares(
            m_settings.outline,
            {.most = curveBound * unit, .outwards = outlineBound * unit, .inwards = inwards},
            m_shares))
      return;
    m_filter.softMinimum(m_shares, std::max(reach, 1), m_line.closed);
    for (std::size_t i = 0; i < m_shares.size(); ++i)
      setMove(i, m_shares[i] * m_line.moveOf(i));
  }

  const std::vector<Segment>& m_segments;
  const PictureView& m_view;
  const CurveSettings& m_settings;
  PressureRule m_pressure;
  glm::vec3 m_right;
  glm::vec3 m_up;
  glm::vec3 m_back;
  PolylineFilter m_filter;
  // Of the line in work, kept from one to the next so that they need not be allocated again.
  std::vector<Chains::Link> m_links;
  std::vector<ChainPoints::Point> m_ends;  ///< of the links: the first one's beginning, then ends
  std::vector<float> m_ways;               ///< to these, px from the line's beginning
  CurveSamples m_line;
  std::vector<float> m_shares;
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
  return curved(segments, chains, pointsInPicture(chains, segments, view), view, settings);
}

std::vector<Segment> curved(const std::vector<Segment>& segments, const Chains& chains,
                            const ChainPoints& points, const PictureView& view,
                            const CurveSettings& settings) {
  std::vector<std::vector<Segment>> parts(chains.count());
  parallelChunks(chains.count(), chainsAtOnce, [&](std::size_t begin, std::size_t end) {
    CurveMaker maker(segments, view, settings);
    std::vector<Segment>& part = parts[begin];
    part.reserve((chains.first[end] - chains.first[begin]) / 2 + (end - begin));
    for (std::size_t chain = begin; chain < end; ++chain)
      maker.add(std::span(chains.links)
                    .subspan(chains.first[chain], chains.first[chain + 1] - chains.first[chain]),
                points.of(chains, chain), part);
  });
  std::size_t count = 0;
  for (const std::vector<Segment>& part : parts)
    count += part.size();
  if (!parts.empty() && count == parts.front().size())
    return std::move(parts.front());
  std::vector<Segment> out;
  out.reserve(count);
  for (const std::vector<Segment>& part : parts)
    out.insert(out.end(), part.begin(), part.end());
  return out;
}

ChainPoints pointsInPicture(const Chains& chains, const std::vector<Segment>& segments,
                            const PictureView& view) {
  ChainPoints found;
  found.points.resize(chains.links.size() + chains.count());
  found.lengths.resize(chains.count(), 0.0f);
  const auto pointOf = [&](const Chains::Link& link, bool atEnd) {
    const Segment& s = segments[link.segment];
    const PictureView::Point point = view.project(atEnd != link.reversed ? s.b : s.a);
    return ChainPoints::Point{point.pixel, point.w};
  };
  ChainPoints::Point* at = found.points.data();
  const std::size_t last = std::max<std::size_t>(chains.links.size(), 1) - 1;
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    *at++ = pointOf(chains.links[chains.first[chain]], false);
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i, ++at) {
      fetch(segments[chains.links[std::min<std::size_t>(i + linksAhead, last)].segment]);
      *at = pointOf(chains.links[i], true);
      found.lengths[chain] += glm::distance(at[-1].pixel, at[0].pixel);
    }
  }
  return found;
}

}  // namespace sline::render
