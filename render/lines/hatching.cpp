// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lines/coarse_depth.h"
#include "render/lines/hatch_seeds.h"
#include "render/lines/stroke_spacing.h"
#include "render/lines/surface_walk.h"
#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
constexpr float step = 2.0f;  // λ from point to point
// Strokes shorter than this many λ each way are dots.
constexpr float shortest = 2.0f * step;
// A stroke narrower than this half width (λ) ends rather than become a grey hair.
constexpr float hair = 0.3f;
constexpr float pen = 0.42f;  // half width at and above which it is drawn as it is
// A pen's point opens by no more than this half width per length.
constexpr float opening = 0.14f;
constexpr float faintest = 0.02f;
constexpr float plain = 0.12f;  // opacity from which on a seed counts in full

float smooth(float low, float high, float x) {
  return glm::smoothstep(low, high, x);
}

/// The thinnest strokes taper off quickly instead of fading.
float definite(float halfWidth) {
  return halfWidth >= pen ? halfWidth : std::max(halfWidth - hair, 0.0f) * pen / (pen - hair);
}

/// Points strokes where they begin and end, without touching ends that stop at a contour.
template <class Samples>
void sharpen(Samples& samples) {
  const auto limit = [](const auto& before, auto& sample) {
    float& width = sample.point.halfWidth;
    width = std::min(width, before.point.halfWidth + opening * step);
  };
  for (std::size_t i = 1; i < samples.size(); ++i)
    limit(samples[i - 1], samples[i]);
  for (std::size_t i = samples.size(); i-- > 1;)
    limit(samples[i], samples[i - 1]);
}

/// How much ink its seed alone would give: its stroke's width, times the area in the picture that
/// the seed stands for.
float seedInk(const PlacedSeed& seed, float entered, const HatchingRequest& request) {
  const float claim = smooth(faintest, plain, hatchOpacity(seed.weight, seed.angle, 1.0f));
  const float opacity = hatchOpacity(seed.weight, seed.angle, entered);
  const float nv = std::cos(1.5707963f * std::min(seed.angle, 1.0f));
  return nv * definite(0.5f * request.spacing * hatchWidth(opacity) * request.tone * seed.presence *
                       claim);
}

/// θ_c is re-timed (METHOD §7 ▲) so that the amount of ink grows evenly with T_H: the value of
/// `entered` at which the seeds' ink is that share of all of it.
float evenlyEntered(const std::vector<PlacedSeed>& seeds, const HatchingRequest& request,
                    const CoarseDepth& depth) {
  constexpr int samples = 32;
  std::array<float, samples + 1> ink{};
  for (const PlacedSeed& s : seeds)
    if (depth.sees(s.position))
      for (int i = 1; i <= samples; ++i)
        ink[std::size_t(i)] += seedInk(s, float(i) / float(samples), request);
  const float wanted = request.entered * ink[samples];
  for (std::size_t i = 1; i <= samples; ++i)
    if (ink[i] >= wanted && ink[i] > ink[i - 1])
      return (float(i - 1) + (wanted - ink[i - 1]) / (ink[i] - ink[i - 1])) / float(samples);
  return 1.0f;
}

class Hatcher {
 public:
  Hatcher(const model::Surface& surface, const model::FaceNeighbours& neighbours,
          const model::Camera& camera, const HatchingRequest& request)
      : m_surface(surface),
        m_neighbours(neighbours),
        m_camera(camera),
        m_request(request),
        m_eye(eyeOf(camera)),
        m_scale(camera),
        m_fields(surface, m_eye, request.twoSided) {}

  Hatching hatch() {
    const std::vector<PlacedSeed> seeds = hatchSeeds(m_surface, m_fields, m_scale, m_request);
    if (seeds.empty())
      return {};
    m_entered = m_request.entered;
    if (m_entered < 1.0f)
      m_entered = evenlyEntered(seeds, m_request, CoarseDepth(m_surface, m_camera));
    glm::vec2 low = m_scale.project(seeds.front().position).at;
    glm::vec2 high = low;
    for (const PlacedSeed& s : seeds) {
      const glm::vec2 at = m_scale.project(s.position).at;
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    StrokeSpacing spacing(m_request.spacing, low, high);
    for (const PlacedSeed& s : seeds)
      addStroke(s, spacing);
    return std::move(m_hatching);
  }

 private:
  struct Sample {
    HatchPoint point;
    StrokeSpacing::Mark mark;
  };

  /// Strokes are laid out as for T_H = 1 and with all lattices whole, so that Γ does not rearrange
  /// them; `share` of that is drawn.
  void addStroke(const PlacedSeed& seed, StrokeSpacing& spacing) {
    const float full = hatchOpacity(seed.weight, seed.angle, 1.0f);
    const ViewScale::Point seen = m_scale.project(seed.position);
    // A stroke is there as far as its seed is: it grows from nothing all along.
    const float room = spacing.room(place(seen, seed.position));
    const float claim = smooth(faintest, plain, full) * smooth(0.0f, 0.9f, room);
    if (claim < faintest)
      return;
    m_samples.clear();
    if (m_request.length < shortest) {
      addDot(seed, {.claim = claim * room, .share = seed.presence});
    } else {
      follow(seed, false, {.claim = claim, .share = seed.presence}, spacing);
      std::reverse(m_samples.begin(), m_samples.end());
      follow(seed, true, {.claim = claim, .share = seed.presence}, spacing);
    }
    claimPlace(spacing);
    sharpen(m_samples);
    keep(seed);
  }

  StrokeSpacing::Place place(const ViewScale::Point& seen, const glm::vec3& position) const {
    // Strokes that touch in the picture lie this near in space if they are on the same sheet.
    return {.at = seen.at,
            .position = position,
            .reachMm = 3.0f * m_request.spacing / std::max(seen.perMm, 1e-20f)};
  }

  glm::vec3 facingNormal(const glm::vec3& normal, const glm::vec3& position) const {
    const bool behind = glm::dot(normal, directionTo(m_eye, position)) < 0.0f;
    return m_request.twoSided && behind ? -normal : normal;
  }

  /// Marks the stroke's place.
  void claimPlace(StrokeSpacing& spacing) {
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      StrokeSpacing::Mark& mark = m_samples[i].mark;
      const glm::vec2 along = m_samples[std::min(i + 1, m_samples.size() - 1)].mark.at -
                              m_samples[i > 0 ? i - 1 : 0].mark.at;
      const float length = glm::length(along);
      mark.direction = length > 0.0f ? along / length : glm::vec2(0.0f);
      if (mark.strength > 0.0f)
        spacing.add(mark);
    }
  }

  struct Presence {
    float claim = 1.0f;  ///< of the place, 0 … 1
    float share = 1.0f;  ///< of what is claimed that is drawn
  };

  void addDot(const PlacedSeed& seed, const Presence& presence) {
    const GradientWalk walk(m_surface, m_neighbours, m_fields, {seed.triangle, seed.barycentric});
    // A disc of radius r in a square of the spacing's side covers πr² of it.
    const auto radius = [&](float entered) {
      const float ink = hatchWidth(hatchOpacity(seed.weight, seed.angle, entered));
      return m_request.spacing * std::sqrt(ink * m_request.tone / 3.14159265f) * presence.claim;
    };
    m_samples.push_back(sample(walk, radius(1.0f), presence.share * radius(m_entered)));
  }

  /// Half widths: what it claims and what is drawn of it.
  Sample sample(const GradientWalk& walk, float claimed, float drawn) const {
    const glm::vec3 position = walk.position();
    return {.point = {position, facingNormal(walk.normal(), position), definite(drawn)},
            .mark = {.at = m_scale.project(position).at,
                     .position = position,
                     .strength = std::min(definite(claimed) / pen, 1.0f)}};
  }

  /// Appends the points from the seed onwards, the seed's own only when going along k.
  void follow(const PlacedSeed& seed, bool along, const Presence& presence,
              const StrokeSpacing& spacing) {
    GradientWalk walk(m_surface, m_neighbours, m_fields, {seed.triangle, seed.barycentric});
    if (!walk.start(along))
      return;
    const float half = 0.5f * m_request.length;
    const float longestGap = m_request.spacing;
    float gap = 0.0f;
    float gone = 0.0f;
    bool more = true;
    if (along)
      m_samples.push_back(inked(walk, presence, spacing));
    while (more && gone < half && gap <= longestGap) {
      const float perMm = m_scale.project(walk.position()).perMm;
      if (!(perMm > 0.0f))
        break;
      more = walk.advance(step / perMm);
      gone += step;
      const float taper = 1.0f - smooth(0.6f, 1.0f, gone / half);
      m_samples.push_back(inked(walk, {presence.claim * taper, presence.share}, spacing));
      gap = m_samples.back().mark.strength > 0.0f ? 0.0f : gap + step;
    }
  }

  Sample inked(const GradientWalk& walk, const Presence& presence,
               const StrokeSpacing& spacing) const {
    const float weight = walk.weight();
    const float angle = std::min(walk.angle(), 0.999f);
    const glm::vec3 position = walk.position();
    const ViewScale::Point seen = m_scale.project(position);
    const float full = hatchOpacity(weight, angle, 1.0f);
    if (!(seen.perMm > 0.0f) || !(full > 0.0f))
      return sample(walk, 0.0f, 0.0f);
    const float room = spacing.room(place(seen, position));
    const float most = 0.5f * m_request.spacing * m_request.tone * room * presence.claim;
    return sample(walk, most * hatchWidth(full),
                  most * hatchWidth(hatchOpacity(weight, angle, m_entered)) * presence.share);
  }

  /// Takes over what is drawn of the samples: without what has no width at the ends.
  void keep(const PlacedSeed& seed) {
    const auto bare = [](const Sample& s) { return !(s.point.halfWidth > 0.0f); };
    auto first = std::find_if_not(m_samples.begin(), m_samples.end(), bare);
    auto last = std::find_if_not(m_samples.rbegin(), m_samples.rend(), bare).base();
    if (first == m_samples.end())
      return;
    if (first != m_samples.begin())
      --first;
    if (last != m_samples.end())
      ++last;
    m_hatching.strokes.push_back({.seed = seed.name,
                                  .seedPosition = seed.position,
                                  .first = std::uint32_t(m_hatching.points.size()),
                                  .count = std::uint32_t(last - first)});
    for (auto it = first; it != last; ++it)
      m_hatching.points.push_back(it->point);
  }

  const model::Surface& m_surface;
  const model::FaceNeighbours& m_neighbours;
  const model::Camera& m_camera;
  const HatchingRequest& m_request;
  model::EyePoint m_eye;
  ViewScale m_scale;
  HatchFields m_fields;
  float m_entered = 1.0f;
  std::vector<Sample> m_samples;
  Hatching m_hatching;
};

}  // namespace

Hatching extractHatching(const model::Surface& surface, const model::FaceNeighbours& neighbours,
                         const model::Camera& camera, const HatchingRequest& request) {
  if (!(request.entered > 0.0f) || !(request.tone > 0.0f) || !(request.spacing > 0.0f))
    return {};
  return Hatcher(surface, neighbours, camera, request).hatch();
}

}  // namespace sline::render
