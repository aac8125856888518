// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/hatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "render/lines/ground/coarse_depth.h"
#include "render/lines/ground/frustum.h"
#include "render/lines/ground/stages.h"
#include "render/lines/ground/view_fields.h"
#include "render/lines/ground/view_scale.h"
#include "render/lines/hatching/hatch_cells.h"
#include "render/lines/hatching/hatch_places.h"
#include "render/lines/hatching/hatch_tone.h"

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

/// A point of a laid stroke in this view.
struct Sample {
  float weight = 0.0f;  ///< see HatchTone
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
        m_view{.eye = m_eye,
               .light = inPatient(request.light, camera),
               .twoSided = request.twoSided,
               .tone = request.tone,
               .filigreeSize = layout.surface().filigreeSize,
               .bare = bareOpacity()},
        m_placesView{m_scale, m_eye, halfHeight * glm::vec2(request.aspect, 1.0f) + margin},
        m_perSpacing(layout.spacing(0) / request.spacing) {}

  Hatching hatch() {
    m_layout.beginView();
    for (const KeptCell* cell : neededCells(m_layout, {m_eye, m_scale, m_frustum, m_request.spacing,
                                                       m_request.twoSided, m_request.mostCells}))
      if (auto tile = m_layout.tile(*cell); !tile->strokes.empty())
        m_tiles.push_back({cell->cell.level, std::move(tile)});
    m_entered = m_request.entered;
    if (varies() || m_entered < 1.0f) {
      measureInk();
      if (!varies())
        m_entered = evenlyEntered(m_entered);
      for (const MeasuredStroke& measured : m_measuredStrokes) {
        recall(measured);
        keepPieces();
      }
    } else {
      forEachStroke([this](int level, const LaidTile& tile, const LaidStroke& stroke) {
        if (sample(level, tile, stroke))
          keepPieces();
      });
    }
    return std::move(m_hatching);
  }

 private:
  bool varies() const { return !m_request.gammas.empty(); }

  struct NeededTile {
    int level;
    std::shared_ptr<const LaidTile> tile;
  };
  /// A stroke on which ink was measured.
  struct MeasuredStroke {
    const LaidTile* tile;
    const LaidStroke* stroke;
    std::size_t first;  ///< in `m_measured`
  };

  template <class Body>
  void forEachStroke(const Body& body) {
    for (const NeededTile& needed : m_tiles)
      for (const LaidStroke& stroke : needed.tile->strokes)
        if (!m_frustum.misses(stroke.bounds) && mayFaceEye(stroke))
          body(needed.level, *needed.tile, stroke);
  }

  bool mayFaceEye(const LaidStroke& stroke) const {
    return m_request.twoSided ||
           model::facing(stroke.bounds, stroke.cone, m_eye) != model::Facing::back;
  }

  /// Samples the stroke; returns false where no sample can have any width.
  bool sample(int level, const LaidTile& tile, const LaidStroke& stroke) {
    if (!m_tone.find(tile, stroke, m_view))
      return false;
    turnTo(tile, stroke);
    m_places.find(tile, stroke, m_placesView, m_tone.facing);
    m_samples.resize(stroke.count);
    const float whole = std::exp2(float(level)) / m_perSpacing;
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
      Sample& s = m_samples[i];
      s = {.weight = m_tone.weight[i],
           .angle = m_tone.angle[i],
           .seen = {m_places.x[i], m_places.y[i]}};
      if (s.weight > 0.0f && s.angle < 1.0f)
        s.presence =
            presence(m_places.perMm[i] / whole) * std::min(1.0f, m_places.across[i] / narrow);
    }
    if (varies())
      for (std::uint32_t i = 0; i < stroke.count; ++i)
        if (m_samples[i].presence > 0.0f)
          m_samples[i].gamma = valueAt(*m_layout.surface().mesh, m_request.gammas,
                                       m_layout.at(tile.points[stroke.first + i]));
    return true;
  }

  /// Returns how much of a level's strokes shows where they are seen that many times as far apart
  /// as they should be.
  static float presence(float apart) {
    return apart >= 1.0f ? 1.0f : apart > 0.5f ? std::log2(2.0f * apart) : 0.0f;
  }

  void turnTo(const LaidTile& tile, const LaidStroke& stroke) {
    m_tile = &tile;
    m_stroke = &stroke;
  }

  glm::vec3 positionOf(std::size_t sample) const { return m_tile->position(*m_stroke, sample); }

  /// Takes the samples of a stroke that ink was measured on.
  void recall(const MeasuredStroke& measured) {
    turnTo(*measured.tile, *measured.stroke);
    const auto first = m_measured.begin() + std::ptrdiff_t(measured.first);
    m_samples.assign(first, first + measured.stroke->count);
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
  void measureInk() {
    constexpr std::uint32_t stride = 3;
    const CoarseDepth depth(m_layout.surface(), m_camera);
    forEachStroke([&](int level, const LaidTile& tile, const LaidStroke& stroke) {
      if (!sample(level, tile, stroke))
        return;
      m_measuredStrokes.push_back({&tile, &stroke, m_measured.size()});
      m_measured.insert(m_measured.end(), m_samples.begin(), m_samples.end());
      for (std::uint32_t i = 0; i < stroke.count; i += stride) {
        const Sample& s = m_samples[i];
        if (!s.inked() || !(hatchOpacity(s.weight, s.angle, 1.0f) > m_view.bare) ||
            !depth.sees(positionOf(i)))
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
    const glm::vec3 normal = m_tile->normal(*m_stroke, i);
    const bool away =
        m_request.twoSided && glm::dot(normal, directionTo(m_eye, positionOf(i))) < 0.0f;
    return (away ? -1.0f : 1.0f) / std::max(glm::length(normal), 1e-20f) * normal;
  }

  /// Returns what is drawn of a sample, without its normal.
  HatchPoint pointAt(std::size_t i) const {
    const Sample& s = m_samples[i];
    return {.position = positionOf(i),
            .halfWidth = halfWidth(s, enteredAt(s)),
            .ink = varies() ? transitions(Gamma::clamped(s.gamma)).lines : 1.0f};
  }

  /// Takes over what is drawn of the samples, piece by piece.
  void keepPieces() {
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
      keepInk(i);
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
  void keepInk(std::size_t sample) {
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
      m_hatching.strokes.push_back({.seed = m_stroke->seed,
                                    .seedPosition = positionOf(m_stroke->seedPoint),
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
  HatchView m_view;
  PlacesView m_placesView;
  float m_perSpacing;  ///< mm between strokes of level 0 over λ between those that are seen
  static constexpr int inkSteps = 32;
  std::array<float, inkSteps + 1> m_ink{};
  float m_entered = 1.0f;
  std::vector<NeededTile> m_tiles;
  const LaidTile* m_tile = nullptr;  ///< of the stroke that is sampled
  const LaidStroke* m_stroke = nullptr;
  HatchTone m_tone;
  HatchPlaces m_places;
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
