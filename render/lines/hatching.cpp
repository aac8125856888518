// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lines/coarse_depth.h"
#include "render/lines/foreshortening.h"
#include "render/lines/frustum.h"
#include "render/lines/hatch_cells.h"
#include "render/lines/hatch_tone.h"
#include "render/lines/stages.h"
#include "render/lines/view_fields.h"
#include "render/lines/view_scale.h"

namespace sline::render {

namespace {
// A stroke narrower than this half width (λ) ends instead of becoming a grey hair. Where all
// strokes are thinner than usual this limit is lower by as much, so that hatching ends in the same
// places.
constexpr float leastHalfWidth = 0.36f;
constexpr float pen = 0.52f;  // half width from which on it is drawn as it is
// The largest share of the space between strokes that ink takes, however dark the tone.
constexpr float mostInk = 0.9f;
// A pen's point opens by no more than this half width per length.
constexpr float opening = 0.14f;
constexpr float halfHeight = 360.0f;  // of the picture, λ, by definition
// Strokes continue this far outside the picture, λ, and may come to a point there.
constexpr float margin = 24.0f;
// Strokes thin out where less than this share of the distance across them is seen.
constexpr float narrow = 0.2f;
// Where less than this is seen they come and go as the surface turns.
constexpr float deep = 0.25f;
constexpr float halfPi = 1.5707963f;

/// A point of a laid stroke in this view.
struct Sample {
  float weight = 0.0f;  ///< see HatchField
  float angle = 2.0f;
  float presence = 0.0f;  ///< 0 … 1: strokes of the finest level grow from nothing
  float gamma = 0.0f;     ///< where it varies
  glm::vec2 seen{0.0f};   ///< λ
  bool inked() const { return weight > 0.0f && angle < 1.0f && presence > 0.0f; }
};

glm::vec3 inPatient(const glm::vec3& direction, const model::Camera& camera) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  return glm::normalize(direction.x * frame.right + direction.y * frame.up +
                        direction.z * frame.back);
}

class Hatcher {
 public:
  Hatcher(StrokeLayout& layout, const model::Camera& camera, const HatchingRequest& request)
      : m_layout(layout),
        m_camera(camera),
        m_request(request),
        m_eye(eyeOf(camera)),
        m_scale(camera),
        m_frustum(camera, request.aspect),
        m_fields(layout.surface(), {.eye = m_eye,
                                    .light = inPatient(request.light, camera),
                                    .twoSided = request.twoSided,
                                    .tone = request.tone}),
        m_bare(bareOpacity()) {}

  Hatching hatch() {
    m_layout.beginView();
    const std::vector<LaidCell> cells =
        neededCells(m_layout, m_fields.clusters(), m_scale, m_frustum, m_request.spacing);
    m_entered = m_request.entered;
    if (varies() || m_entered < 1.0f) {
      measureInk(cells);
      if (!varies())
        m_entered = evenlyEntered(m_entered);
      for (const MeasuredStroke& measured : m_measuredStrokes) {
        recall(measured);
        keepPieces(measured.tile->positions[measured.stroke->seedPoint], measured.stroke->seed);
      }
    } else {
      forEachStroke(cells, [this](int level, const TilePtr& tile, const LaidStroke& stroke) {
        if (sample(level, *tile, stroke))
          keepPieces(tile->positions[stroke.seedPoint], stroke.seed);
      });
    }
    return std::move(m_hatching);
  }

 private:
  bool varies() const { return !m_request.gammas.empty(); }

  using TilePtr = std::shared_ptr<const LaidTile>;
  /// A stroke on which ink was measured.
  struct MeasuredStroke {
    TilePtr tile;
    const LaidStroke* stroke;
    std::size_t first;  ///< in `m_measured`
  };

  template <class Body>
  void forEachStroke(const std::vector<LaidCell>& cells, const Body& body) {
    for (const LaidCell& cell : cells) {
      const TilePtr tile = m_layout.tile(cell);
      for (const LaidStroke& stroke : tile->strokes)
        if (!m_frustum.misses(stroke.bounds))
          body(cell.level, tile, stroke);
    }
  }

  /// Samples the stroke; returns false where no sample can have any width.
  bool sample(int level, const LaidTile& tile, const LaidStroke& stroke) {
    turnTo(tile, stroke);
    m_samples.assign(stroke.count, Sample());
    const std::uint32_t end = stroke.first + stroke.count;
    std::uint32_t from = stroke.first;
    for (const LaidRun* run = &tile.runs[stroke.firstRun]; from < end; from = run++->end)
      if (m_fields.facesEye(run->cluster))
        sampleRun(run->cluster, from - stroke.first, run->end - stroke.first);
    if (std::none_of(m_samples.begin(), m_samples.end(), [this](const Sample& s) {
          return hatchOpacity(s.weight, s.angle, 1.0f) > m_bare;
        }))
      return false;
    for (std::uint32_t i = 0; i < stroke.count; ++i)
      if (m_samples[i].weight > 0.0f && m_samples[i].angle < 1.0f)
        place(level, i);
    return true;
  }

  void turnTo(const LaidTile& tile, const LaidStroke& stroke) {
    m_points = std::span(tile.points).subspan(stroke.first, stroke.count);
    m_positions = std::span(tile.positions).subspan(stroke.first, stroke.count);
  }

  /// Takes the samples of a stroke that ink was measured on.
  void recall(const MeasuredStroke& measured) {
    turnTo(*measured.tile, *measured.stroke);
    const auto first = m_measured.begin() + std::ptrdiff_t(measured.first);
    m_samples.assign(first, first + measured.stroke->count);
  }

  /// Interpolates the fields at points of one cluster, which others behind the contour lack.
  void sampleRun(std::uint32_t index, std::uint32_t from, std::uint32_t end) {
    const model::Clusters& clusters = m_layout.surface().clusters;
    const std::size_t first = clusters.items[index].firstVertex;
    for (std::uint32_t i = from; i < end; ++i) {
      Sample& s = m_samples[i];
      const glm::vec3 b = m_layout.barycentric(m_points[i]);
      const auto& [c0, c1, c2] = clusters.localTriangles[m_points[i].slot];
      const HatchField f0 = m_fields[first + c0];
      const HatchField f1 = m_fields[first + c1];
      const HatchField f2 = m_fields[first + c2];
      s.weight = b.x * f0.weight + b.y * f1.weight + b.z * f2.weight;
      s.angle = b.x * f0.angle + b.y * f1.angle + b.z * f2.angle;
      if (varies())
        s.gamma = b.x * m_request.gammas[clusters.vertices[first + c0]] +
                  b.y * m_request.gammas[clusters.vertices[first + c1]] +
                  b.z * m_request.gammas[clusters.vertices[first + c2]];
    }
  }

  /// Finds where the sample is seen, and how much of it belongs to its level.
  void place(int level, std::uint32_t i) {
    Sample& s = m_samples[i];
    const ViewScale::Point seen = m_scale.project(m_positions[i]);
    s.seen = seen.at;
    if (!(seen.perMm > 0.0f) || std::abs(seen.at.y) > halfHeight + margin ||
        std::abs(seen.at.x) > m_request.aspect * halfHeight + margin)
      return;
    const glm::vec3& next = m_positions[std::min<std::size_t>(i + 1, m_samples.size() - 1)];
    const glm::vec3 along = next - m_positions[i > 0 ? i - 1 : 0];
    const float nv = std::cos(halfPi * s.angle);
    const float across = seenAcross(nv, along, directionTo(m_eye, m_positions[i]));
    // Strokes along a contour thin out; otherwise they would go behind it all at once.
    const float seenLevel =
        hatchLevel(m_layout, seen.perMm * widened(across, deep), m_request.spacing);
    s.presence =
        std::clamp(seenLevel + 1.0f - float(level), 0.0f, 1.0f) * std::min(1.0f, across / narrow);
  }

  /// Returns a half width with which the thinnest strokes taper off quickly instead of fading.
  /// `usual` is how much thinner or wider than usual all strokes are.
  static float definite(float halfWidth, float usual) {
    const float least = leastHalfWidth * usual;
    const float whole = pen * usual;
    return halfWidth >= whole ? halfWidth
                              : std::max(halfWidth - least, 0.0f) * whole / (whole - least);
  }

  float halfWidth(const Sample& s, float entered) const {
    const float share =
        std::min(hatchWidth(hatchOpacity(s.weight, s.angle, entered)) * m_request.tone, mostInk);
    const float closer = m_request.spacing / hatchSpacing;
    // Darker strokes still end in fine points.
    if (m_layout.length() > 0.0f)
      return definite(0.5f * m_request.spacing * share * s.presence,
                      closer * std::min(m_request.tone, 1.0f));
    // A disc of radius r in a square of the spacing's side covers πr² of it.
    return definite(m_request.spacing * std::sqrt(share / 3.14159265f) * s.presence,
                    std::sqrt(m_request.tone));
  }

  /// Returns an opacity at which strokes still have no width where all of their level shows.
  float bareOpacity() const {
    float bare = 0.0f;
    for (float step = 0.5f; step > 1e-3f; step *= 0.5f)
      if (!(halfWidth({.weight = 2.0f * (bare + step), .angle = 0.5f, .presence = 1.0f}, 1.0f) >
            0.0f))
        bare += step;
    return 0.999f * bare;
  }

  /// Finds how much ink the strokes have for some values of `entered`.
  void measureInk(const std::vector<LaidCell>& cells) {
    constexpr std::uint32_t stride = 3;
    const CoarseDepth depth(m_layout.surface(), m_camera);
    forEachStroke(cells, [&](int level, const TilePtr& tile, const LaidStroke& stroke) {
      if (!sample(level, *tile, stroke))
        return;
      m_measuredStrokes.push_back({tile, &stroke, m_measured.size()});
      m_measured.insert(m_measured.end(), m_samples.begin(), m_samples.end());
      for (std::uint32_t i = 0; i < stroke.count; i += stride) {
        const Sample& s = m_samples[i];
        if (!s.inked() || !(hatchOpacity(s.weight, s.angle, 1.0f) > m_bare) ||
            !depth.sees(m_positions[i]))
          continue;
        const Sample& before = m_samples[i > 0 ? i - 1 : 0];
        const float length = before.inked() ? glm::distance(before.seen, s.seen) : 0.0f;
        for (int step = inkSteps; step > 0; --step) {
          const float width = halfWidth(s, float(step) / float(inkSteps));
          if (!(width > 0.0f))
            break;  // nor has it any before
          m_ink[std::size_t(step)] += m_layout.length() > 0.0f ? width * length : width * width;
        }
      }
    });
  }

  /// Re-times θ_c (METHOD §7 ▲) so that the amount of ink grows evenly with T_H: returns the value
  /// of `entered` at which the strokes' ink is that share of all of it.
  float evenlyEntered(float share) const {
    const float wanted = share * m_ink[inkSteps];
    for (std::size_t i = 1; i <= inkSteps; ++i)
      if (m_ink[i] >= wanted && m_ink[i] > m_ink[i - 1])
        return (float(i - 1) + (wanted - m_ink[i - 1]) / (m_ink[i] - m_ink[i - 1])) /
               float(inkSteps);
    return 1.0f;
  }

  float enteredAt(const Sample& s) const {
    if (!varies())
      return m_entered;
    const float share = transitions(Gamma::clamped(s.gamma)).hatching;
    return share > 0.0f && share < 1.0f ? evenlyEntered(share) : share;
  }

  glm::vec3 normalAt(std::size_t i) const {
    const model::Surface& surface = m_layout.surface();
    glm::vec3 normal = valueAt(*surface.mesh, surface.normals, m_layout.at(m_points[i]));
    normal /= std::max(glm::length(normal), 1e-20f);
    const bool away =
        m_request.twoSided && glm::dot(normal, directionTo(m_eye, m_positions[i])) < 0.0f;
    return away ? -normal : normal;
  }

  /// Returns what is drawn of a sample, without its normal.
  HatchPoint pointAt(std::size_t i) const {
    const Sample& s = m_samples[i];
    return {.position = m_positions[i],
            .halfWidth = halfWidth(s, enteredAt(s)),
            .ink = varies() ? transitions(Gamma::clamped(s.gamma)).lines : 1.0f};
  }

  /// Takes over what is drawn of the samples, piece by piece.
  void keepPieces(const glm::vec3& seedPosition, const HatchSeed& seed) {
    for (std::size_t i = 0; i < m_samples.size();) {
      if (!m_samples[i].inked()) {
        ++i;
        continue;
      }
      std::size_t end = i;
      m_piece.clear();
      m_along.clear();
      for (; end < m_samples.size() && m_samples[end].inked(); ++end) {
        m_piece.push_back(pointAt(end));
        m_along.push_back(m_samples[end].seen);
      }
      if (m_piece.size() > 1)
        sharpen(i > 0 && m_samples[i - 1].angle >= 1.0f,
                end < m_samples.size() && m_samples[end].angle >= 1.0f);
      if (m_layout.length() > 0.0f)
        slim();
      keepInk(seedPosition, seed, i);
      i = end;
    }
  }

  /// Tapers a piece to a point at its ends, except where it continues behind a contour.
  void sharpen(bool fromBehind, bool onBehind) {
    if (!fromBehind)
      m_piece.front().halfWidth = 0.0f;
    if (!onBehind)
      m_piece.back().halfWidth = 0.0f;
    const auto limit = [this](std::size_t i, std::size_t neighbour) {
      const float length = glm::distance(m_along[i], m_along[neighbour]);
      float& width = m_piece[i].halfWidth;
      width = std::min(width, m_piece[neighbour].halfWidth + opening * length);
    };
    for (std::size_t i = 1; i < m_piece.size(); ++i)
      limit(i, i - 1);
    for (std::size_t i = m_piece.size() - 1; i-- > 0;)
      limit(i, i + 1);
  }

  /// Keeps a piece longer than it is wide: what is left of a stroke that has hardly any room, or is
  /// seen along its length, becomes thin and goes, instead of standing as a dot.
  void slim() {
    float length = 0.0f;
    for (std::size_t i = 1; i < m_along.size(); ++i)
      length += glm::distance(m_along[i - 1], m_along[i]);
    for (HatchPoint& point : m_piece)
      point.halfWidth = std::min(point.halfWidth, opening * length);
  }

  /// Keeps the points that have width, and one more at either end; the piece begins at that sample.
  void keepInk(const glm::vec3& seedPosition, const HatchSeed& seed, std::size_t sample) {
    const auto bare = [](const HatchPoint& p) { return !(p.halfWidth > 0.0f); };
    for (auto it = m_piece.begin(); it != m_piece.end();) {
      auto first = std::find_if_not(it, m_piece.end(), bare);
      if (first == m_piece.end())
        return;
      auto last = std::find_if(first, m_piece.end(), bare);
      it = last;
      if (first != m_piece.begin())
        --first;
      if (last != m_piece.end())
        ++last;
      for (auto point = first; point != last; ++point)
        point->normal = normalAt(sample + std::size_t(point - m_piece.begin()));
      m_hatching.strokes.push_back({.seed = seed,
                                    .seedPosition = seedPosition,
                                    .first = std::uint32_t(m_hatching.points.size()),
                                    .count = std::uint32_t(last - first)});
      m_hatching.points.insert(m_hatching.points.end(), first, last);
    }
  }

  StrokeLayout& m_layout;
  const model::Camera& m_camera;
  const HatchingRequest& m_request;
  model::EyePoint m_eye;
  ViewScale m_scale;
  Frustum m_frustum;
  HatchFields m_fields;
  float m_bare;  ///< see `bareOpacity`
  static constexpr int inkSteps = 32;
  std::array<float, inkSteps + 1> m_ink{};
  float m_entered = 1.0f;
  std::span<const LaidPoint> m_points;     ///< of the stroke that is sampled
  std::span<const glm::vec3> m_positions;  ///< likewise
  std::vector<Sample> m_samples;
  std::vector<MeasuredStroke> m_measuredStrokes;
  std::vector<Sample> m_measured;  ///< of these
  std::vector<HatchPoint> m_piece;
  std::vector<glm::vec2> m_along;
  Hatching m_hatching;
};

}  // namespace

float spacingOf(HatchDensity density) {
  return hatchSpacing * std::pow(density.value(), -2.0f / 3.0f);
}

Hatching extractHatching(StrokeLayout& layout, const model::Camera& camera,
                         const HatchingRequest& request) {
  if ((!(request.entered > 0.0f) && request.gammas.empty()) || !(request.tone > 0.0f) ||
      !(request.spacing > 0.0f) || !std::isfinite(request.spacing))
    return {};
  return Hatcher(layout, camera, request).hatch();
}

}  // namespace sline::render
