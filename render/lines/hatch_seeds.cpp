// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_seeds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

namespace sline::render {

namespace {
constexpr float pictureHeight = 720.0f;  // λ, by definition
// Strokes of seeds this far outside of the picture may still reach into it, λ.
constexpr float apron = 80.0f;
constexpr int coarsestLevel = -8;
constexpr int finestLevel = 24;
// A triangle larger than this many cells each way gets coarser seeds: it fills many pictures.
constexpr float largestSpan = 512.0f;
constexpr float cellShare = 0.7f;
constexpr float faintest = 0.01f;

/// Scatters the lattice's points; the same for a point and its mirror images.
std::uint32_t scattered(const HatchSeed& s) {
  std::uint32_t h = std::uint32_t(std::abs(s.i)) * 0x9e3779b1u;
  h ^= std::uint32_t(std::abs(s.j)) * 0x85ebca77u + (h << 6) + (h >> 2);
  h ^= std::uint32_t(s.axis) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  return h ^ (h >> 15);
}

/// The coarsest lattice that holds point (i, j) of the lattice of that level.
HatchSeed named(int axis, int level, std::int32_t i, std::int32_t j) {
  const std::uint32_t both = std::uint32_t(i) | std::uint32_t(j);
  const int shared = both == 0 ? 30 : std::countr_zero(both);
  const int up = std::min(shared, level - coarsestLevel);
  return {.axis = axis, .level = level - up, .i = i / (1 << up), .j = j / (1 << up)};
}

class Seeder {
 public:
  Seeder(const model::Surface& surface, const HatchFields& fields, const ViewScale& scale,
         const HatchingRequest& request)
      : m_surface(surface), m_fields(fields), m_scale(scale), m_request(request) {}

  void seed(const model::Cluster& cluster) {
    const ViewScale::Point middle = m_scale.project(cluster.bounds.centre);
    const glm::vec3 nearest = nearestPoint(cluster.bounds);
    const float perMm = std::max(m_scale.project(nearest).perMm, middle.perMm);
    if (!(perMm > 0.0f) || outside(middle, cluster.bounds.radius))
      return;
    const int finest = int(std::ceil(levelAt(perMm)));
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i)
      seed(m_surface.clusters.triangles[cluster.firstTriangle + i],
           std::clamp(finest, coarsestLevel, finestLevel));
  }

  std::vector<PlacedSeed> take() {
    const auto order = [](const PlacedSeed& s) {
      const HatchSeed& n = s.name;
      return std::tuple(n.level, scattered(n), n.axis, n.i, n.j, s.triangle);
    };
    std::sort(m_seeds.begin(), m_seeds.end(),
              [&](const PlacedSeed& a, const PlacedSeed& b) { return order(a) < order(b); });
    return std::move(m_seeds);
  }

 private:
  /// The level, with its fraction, whose cells are `cellShare` times as wide as strokes are apart;
  /// those of the whole level below are up to twice as wide.
  float levelAt(float perMm) const {
    return std::log2(m_surface.filigreeSize * perMm / (cellShare * m_request.spacing));
  }

  glm::vec3 nearestPoint(const model::Sphere& bounds) const {
    const ViewScale::Point centre = m_scale.project(bounds.centre);
    return bounds.centre + m_scale.towardsEye() * std::min(bounds.radius, 0.9f * centre.distanceMm);
  }

  bool outside(const ViewScale::Point& p, float radiusMm) const {
    const float reach = radiusMm * p.perMm * 1.5f + apron + 0.5f * pictureHeight;
    return std::abs(p.at.y) > reach ||
           std::abs(p.at.x) > reach + 0.5f * pictureHeight * (m_request.aspect - 1.0f);
  }

  void seed(std::uint32_t triangle, int level) {
    const model::Triangle& t = m_surface.mesh->triangles()[triangle];
    const HatchField& f0 = m_fields[t[0]];
    const HatchField& f1 = m_fields[t[1]];
    const HatchField& f2 = m_fields[t[2]];
    if (std::max({f0.weight, f1.weight, f2.weight}) < faintest ||
        std::min({f0.angle, f1.angle, f2.angle}) >= 1.0f)
      return;
    const auto positions = m_surface.mesh->positions();
    const std::array<glm::vec3, 3> p{positions[t[0]], positions[t[1]], positions[t[2]]};
    const glm::vec3 normal = glm::abs(glm::cross(p[1] - p[0], p[2] - p[0]));
    const int axis = normal.x >= normal.y && normal.x >= normal.z ? 0
                     : normal.y >= normal.z                       ? 1
                                                                  : 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::array<glm::vec2, 3> q;
    const auto place = [&](int at) {
      const float cell = std::ldexp(m_surface.filigreeSize, -at);
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3 local = (p[c] - m_surface.boundingSphere.centre) / cell;
        q[c] = {local[u], local[v]};
      }
      const glm::vec2 size =
          glm::max(glm::max(q[0], q[1]), q[2]) - glm::min(glm::min(q[0], q[1]), q[2]);
      return std::max(size.x, size.y);
    };
    while (place(level) > largestSpan && level > coarsestLevel)
      --level;
    scan(triangle, {axis, level}, q);
  }

  struct Lattice {
    int axis;
    int level;
  };

  /// Every lattice point within the triangle's projection.
  void scan(std::uint32_t triangle, const Lattice& lattice, const std::array<glm::vec2, 3>& q) {
    const glm::vec2 low = glm::ceil(glm::min(glm::min(q[0], q[1]), q[2]));
    const glm::vec2 high = glm::floor(glm::max(glm::max(q[0], q[1]), q[2]));
    const glm::vec2 a = q[1] - q[0];
    const glm::vec2 b = q[2] - q[0];
    const float area = a.x * b.y - a.y * b.x;
    if (area == 0.0f || glm::any(glm::greaterThan(glm::abs(low), glm::vec2(1e9f))))
      return;
    for (float y = low.y; y <= high.y; y += 1.0f)
      for (float x = low.x; x <= high.x; x += 1.0f) {
        const glm::vec2 d = glm::vec2(x, y) - q[0];
        const float b1 = (d.x * b.y - d.y * b.x) / area;
        const float b2 = (a.x * d.y - a.y * d.x) / area;
        if (b1 >= 0.0f && b2 >= 0.0f && b1 + b2 <= 1.0f)
          add(triangle, {1.0f - b1 - b2, b1, b2},
              named(lattice.axis, lattice.level, std::int32_t(x), std::int32_t(y)));
      }
  }

  void add(std::uint32_t triangle, const glm::vec3& at, const HatchSeed& name) {
    const model::Triangle& t = m_surface.mesh->triangles()[triangle];
    const auto positions = m_surface.mesh->positions();
    const auto mix = [&](const auto& x, const auto& y, const auto& z) {
      return at.x * x + at.y * y + at.z * z;
    };
    PlacedSeed seed{.name = name,
                    .triangle = triangle,
                    .barycentric = at,
                    .position = mix(positions[t[0]], positions[t[1]], positions[t[2]])};
    seed.weight = mix(m_fields[t[0]].weight, m_fields[t[1]].weight, m_fields[t[2]].weight);
    seed.angle = mix(m_fields[t[0]].angle, m_fields[t[1]].angle, m_fields[t[2]].angle);
    const ViewScale::Point seen = m_scale.project(seed.position);
    if (seed.weight < faintest || seed.angle >= 1.0f || !(seen.perMm > 0.0f) || outside(seen, 0.0f))
      return;
    seed.presence = std::clamp(levelAt(seen.perMm) + 1.0f - float(name.level), 0.0f, 1.0f);
    if (seed.presence > 0.0f)
      m_seeds.push_back(seed);
  }

  const model::Surface& m_surface;
  const HatchFields& m_fields;
  const ViewScale& m_scale;
  const HatchingRequest& m_request;
  std::vector<PlacedSeed> m_seeds;
};

}  // namespace

std::vector<PlacedSeed> hatchSeeds(const model::Surface& surface, const HatchFields& fields,
                                   const ViewScale& scale, const HatchingRequest& request) {
  Seeder seeder(surface, fields, scale, request);
  for (const std::uint32_t c : fields.clusters())
    seeder.seed(surface.clusters.items[c]);
  return seeder.take();
}

}  // namespace sline::render
