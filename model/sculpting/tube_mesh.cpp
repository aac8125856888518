// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/tube_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
/// A tube that the body leaves hardly any room is this share of its width wide.
constexpr float narrowest = 0.2f;

/// Derives a ring from the wall's radius r there: share · (r − inset).
struct Ring {
  float along;
  float share = 1.0f;
  float inset = 0.0f;
};

/// Returns the rings with square ends and rounded rims; the discs at the ends are rings too.
std::vector<Ring> ringsOf(const TubeStretch& stretch) {
  std::vector<Ring> rings;
  const auto end = [&](float along, float inward) {
    std::vector<Ring> cap;
    for (const float share : {0.33f, 0.67f, 1.0f})
      cap.push_back({along, share, stretch.rim});
    for (const float turn : {0.33f, 0.67f}) {
      const float angle = 0.5f * std::numbers::pi_v<float> * turn;
      cap.push_back({along + inward * stretch.rim * (1.0f - std::cos(angle)), 1.0f,
                     stretch.rim * (1.0f - std::sin(angle))});
    }
    return cap;
  };
  rings = end(stretch.from, 1.0f);
  const float first = stretch.from + stretch.rim;
  const float length = stretch.to - stretch.rim - first;
  // Rings of equilateral triangles are closer together than their edges are long.
  const int steps = std::max(1, int(std::lround(length / (0.87f * stretch.edge))));
  for (int i = 0; i <= steps; ++i)
    rings.push_back({first + length * float(i) / float(steps)});
  const std::vector<Ring> last = end(stretch.to, -1.0f);
  rings.insert(rings.end(), last.rbegin(), last.rend());
  return rings;
}

/// Returns how far the body reaches from the centre line.
float reachOf(const Field& solid, const SweptRing& ring, const glm::vec3& direction) {
  float inside = narrowest * ring.radius;
  float outside = ring.radius;
  const auto at = [&](float r) { return solid(ring.position + r * direction); };
  if (at(outside) <= 0.0f)
    return outside;
  // This finds the first place outwards where the body ends, then bisects.
  constexpr int steps = 5;
  for (int i = 1; i <= steps; ++i) {
    const float r = ring.radius * (narrowest + (1.0f - narrowest) * float(i) / float(steps));
    if (at(r) > 0.0f) {
      outside = r;
      break;
    }
    inside = r;
  }
  for (int i = 0; i < 6; ++i) {
    const float middle = 0.5f * (inside + outside);
    (at(middle) > 0.0f ? outside : inside) = middle;
  }
  return 0.5f * (inside + outside);
}

/// Softens the edges of dents by the weights 1 2 1 around each ring and along the tube.
void soften(std::vector<float>& reach, std::size_t around, int passes) {
  const std::size_t rings = reach.size() / around;
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<float> before = reach;
    for (std::size_t i = 0; i < rings; ++i)
      for (std::size_t j = 0; j < around; ++j)
        reach[i * around + j] = 0.5f * before[i * around + j] +
                                0.25f * (before[i * around + (j + 1) % around] +
                                         before[i * around + (j + around - 1) % around]);
    before = reach;
    for (std::size_t i = 1; i + 1 < rings; ++i)
      for (std::size_t j = 0; j < around; ++j)
        reach[i * around + j] =
            0.5f * before[i * around + j] +
            0.25f * (before[(i - 1) * around + j] + before[(i + 1) * around + j]);
  }
}

/// Returns rings of `around` vertices, each turned by half a step relative to the one before, and a
/// vertex at either end.
std::vector<Triangle> ringTriangles(std::size_t rings, std::size_t around) {
  std::vector<Triangle> triangles;
  const auto at = [around](std::size_t i, std::size_t j) {
    return std::uint32_t(i * around + j % around);
  };
  for (std::size_t i = 0; i + 1 < rings; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const std::size_t ahead = i % 2;
      triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + ahead)});
      triangles.push_back({at(i, j + 1 - ahead), at(i + 1, j + 1), at(i + 1, j)});
    }
  const auto first = std::uint32_t(rings * around);
  for (std::size_t j = 0; j < around; ++j) {
    triangles.push_back({first, at(0, j + 1), at(0, j)});
    triangles.push_back({first + 1, at(rings - 1, j), at(rings - 1, j + 1)});
  }
  return triangles;
}
}  // namespace

MeshPtr tubeMesh(const Swept& tube, const TubeStretch& stretch, const Field& solid) {
  constexpr float turn = 2.0f * std::numbers::pi_v<float>;
  const std::vector<Ring> rings = ringsOf(stretch);
  const float middle = tube.ring(0.5f * (stretch.from + stretch.to)).radius;
  const auto around = std::size_t(std::max(8L, std::lround(turn * middle / stretch.edge)));
  const auto direction = [&](const SweptRing& ring, std::size_t i, std::size_t j) {
    const float angle = turn * (float(j) + 0.5f * float(i % 2)) / float(around);
    return std::cos(angle) * ring.front + std::sin(angle) * ring.side;
  };

  std::vector<float> reach(rings.size() * around);
  parallelFor(rings.size(), 8, [&](std::size_t i) {
    const SweptRing ring = tube.ring(rings[i].along);
    for (std::size_t j = 0; j < around; ++j)
      reach[i * around + j] = reachOf(solid, ring, direction(ring, i, j));
  });
  soften(reach, around, 1);

  std::vector<glm::vec3> positions(reach.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const SweptRing ring = tube.ring(rings[i].along);
    for (std::size_t j = 0; j < around; ++j) {
      const float r = std::max(reach[i * around + j] - rings[i].inset, 0.1f * ring.radius);
      positions[i * around + j] = ring.position + rings[i].share * r * direction(ring, i, j);
    }
  }
  positions.push_back(tube.ring(stretch.from).position);
  positions.push_back(tube.ring(stretch.to).position);
  auto mesh = Mesh::create(std::move(positions), ringTriangles(rings.size(), around));
  return std::make_shared<const Mesh>(std::move(mesh).value());
}

}  // namespace sline::model
