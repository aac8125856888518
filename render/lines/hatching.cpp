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
constexpr float hair = 0.27f;
constexpr float pen = 0.5f;  // half width at and above which it is drawn as it is
// A pen's point opens by no more than this half width per length.
constexpr float opening = 0.14f;
// Steps that a stroke may be thinner than a hair before it ends.
constexpr int longestGap = 3;
constexpr float faintest = 0.01f;
constexpr float plain = 0.07f;  // opacity from which on a seed counts in full

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

float seedPresence(const PlacedSeed& seed, float opacity) {
  return seed.presence * smooth(faintest, plain, opacity);
}

/// How much ink its seed alone would give: its stroke's width, times the area in the picture that
/// the seed stands for.
float seedInk(const PlacedSeed& seed, float entered, const HatchingRequest& request) {
  const float opacity = hatchOpacity(seed.weight, seed.angle, entered);
  const float nv = std::cos(1.5707963f * std::min(seed.angle, 1.0f));
  return nv * definite(0.5f * request.spacing * hatchWidth(opacity) * request.tone *
                       seedPresence(seed, opacity));
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

  void addStroke(const PlacedSeed& seed, StrokeSpacing& spacing) {
    const float opacity = hatchOpacity(seed.weight, seed.angle, m_entered);
    if (opacity < faintest)
      return;
    const ViewScale::Point seen = m_scale.project(seed.position);
    // A stroke is there as far as its seed is: it grows from nothing all along.
    const float room = spacing.room(seen.at, seed.position, reach(seen));
    const float presence = seedPresence(seed, opacity) * smooth(0.0f, 0.6f, room);
    if (presence < faintest)
      return;
    const bool dot = m_request.length < shortest;
    std::vector<Sample>& samples = m_samples;
    samples.clear();
    if (dot) {
      addDot(seed, presence * room, samples);
    } else {
      follow(seed, false, presence, spacing);
      std::reverse(samples.begin(), samples.end());
      follow(seed, true, presence, spacing);
    }
    sharpen(samples);
    keep(seed, spacing);
  }

  /// How far in space two strokes that touch in the picture may lie on the same sheet, mm.
  float reach(const ViewScale::Point& seen) const {
    return 3.0f * m_request.spacing / std::max(seen.perMm, 1e-20f);
  }

  glm::vec3 facingNormal(const glm::vec3& normal, const glm::vec3& position) const {
    const bool behind = glm::dot(normal, directionTo(m_eye, position)) < 0.0f;
    return m_request.twoSided && behind ? -normal : normal;
  }

  void addDot(const PlacedSeed& seed, float presence, std::vector<Sample>& samples) {
    GradientWalk walk(m_surface, m_neighbours, m_fields, {seed.triangle, seed.barycentric});
    // A disc of radius r in a square of the spacing's side covers πr² of it.
    const float share =
        hatchWidth(hatchOpacity(seed.weight, seed.angle, m_entered)) * m_request.tone;
    const float radius = m_request.spacing * std::sqrt(share / 3.14159265f) * presence;
    samples.push_back(sample(walk, definite(radius)));
  }

  Sample sample(const GradientWalk& walk, float halfWidth) const {
    const glm::vec3 position = walk.position();
    const ViewScale::Point seen = m_scale.project(position);
    return {.point = {position, facingNormal(walk.normal(), position), halfWidth},
            .mark = {.at = seen.at, .position = position, .strength = halfWidth / pen}};
  }

  /// Appends the points from the seed onwards, the seed's own only when going along k.
  void follow(const PlacedSeed& seed, bool along, float presence, const StrokeSpacing& spacing) {
    GradientWalk walk(m_surface, m_neighbours, m_fields, {seed.triangle, seed.barycentric});
    if (!walk.start(along))
      return;
    const float half = 0.5f * m_request.length;
    int gap = 0;
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
      m_samples.push_back(inked(walk, presence * taper, spacing));
      gap = m_samples.back().point.halfWidth > 0.0f ? 0 : gap + 1;
    }
  }

  Sample inked(const GradientWalk& walk, float presence, const StrokeSpacing& spacing) const {
    const glm::vec3 position = walk.position();
    const ViewScale::Point seen = m_scale.project(position);
    float halfWidth = 0.0f;
    if (seen.perMm > 0.0f) {
      const float opacity = hatchOpacity(walk.weight(), std::min(walk.angle(), 0.999f), m_entered);
      const float room = opacity > 0.0f ? spacing.room(seen.at, position, reach(seen)) : 0.0f;
      halfWidth = 0.5f * m_request.spacing * hatchWidth(opacity) * m_request.tone * room * presence;
    }
    return sample(walk, definite(halfWidth));
  }

  /// Takes the stroke's samples over, without what has no width at its ends.
  void keep(const PlacedSeed& seed, StrokeSpacing& spacing) {
    const auto bare = [](const Sample& s) { return !(s.point.halfWidth > 0.0f); };
    auto first = std::find_if_not(m_samples.begin(), m_samples.end(), bare);
    auto last = std::find_if_not(m_samples.rbegin(), m_samples.rend(), bare).base();
    if (first == m_samples.end())
      return;
    if (first != m_samples.begin())
      --first;
    if (last != m_samples.end())
      ++last;
    const HatchStroke stroke{.seed = seed.name,
                             .seedPosition = seed.position,
                             .first = std::uint32_t(m_hatching.points.size()),
                             .count = std::uint32_t(last - first)};
    for (auto it = first; it != last; ++it) {
      const glm::vec2 before = (it == first ? it : it - 1)->mark.at;
      const glm::vec2 after = (it + 1 == last ? it : it + 1)->mark.at;
      const float length = glm::length(after - before);
      it->mark.direction = length > 0.0f ? (after - before) / length : glm::vec2(0.0f);
      it->mark.strength = std::min(it->mark.strength, 1.0f);
      if (it->mark.strength > 0.0f)
        spacing.add(it->mark);
      m_hatching.points.push_back(it->point);
    }
    m_hatching.strokes.push_back(stroke);
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
