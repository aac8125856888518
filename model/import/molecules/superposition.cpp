// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/superposition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sline::model {

namespace {

using PlacePair = std::pair<glm::dvec3, glm::dvec3>;
using Symmetric4 = std::array<std::array<double, 4>, 4>;

constexpr double nearEnough = 2.0;
constexpr std::size_t mostCells = 400'000'000;

/// One rotation of Jacobi's method: makes m[p][q] zero and keeps the eigenvectors in `v`.
void rotate(Symmetric4& m, Symmetric4& v, int p, int q) {
  if (m[p][q] == 0.0)
    return;
  const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
  const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1.0 / std::hypot(t, 1.0);
  const double s = t * c;
  for (int k = 0; k < 4; ++k) {
    const double a = m[k][p];
    const double b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (int k = 0; k < 4; ++k) {
    const double a = m[p][k];
    const double b = m[q][k];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
    const double x = v[k][p];
    const double y = v[k][q];
    v[k][p] = c * x - s * y;
    v[k][q] = s * x + c * y;
  }
}

/// The eigenvector of the largest eigenvalue.
std::array<double, 4> mainAxis(Symmetric4 m) {
  Symmetric4 v{};
  for (int i = 0; i < 4; ++i)
    v[i][i] = 1.0;
  for (int sweep = 0; sweep < 50; ++sweep)
    for (int p = 0; p < 3; ++p)
      for (int q = p + 1; q < 4; ++q)
        rotate(m, v, p, q);
  int best = 0;
  for (int i = 1; i < 4; ++i)
    best = m[i][i] > m[best][best] ? i : best;
  return {v[0][best], v[1][best], v[2][best], v[3][best]};
}

double squaredDistance(const RigidMotion& motion, const PlacePair& pair) {
  const glm::dvec3 off = motion(pair.first) - pair.second;
  return glm::dot(off, off);
}

/// Fits, leaves out the worst pairs and fits again until all are near; those that turn out to be
/// near in the end count again.
Superposition fitted(const std::vector<PlacePair>& all) {
  Superposition result;
  result.aligned = all.size();
  std::vector<PlacePair> pairs = all;
  const auto isFar = [&](const PlacePair& p) {
    return squaredDistance(result.motion, p) > nearEnough * nearEnough;
  };
  const auto isWorse = [&](const PlacePair& a, const PlacePair& b) {
    return squaredDistance(result.motion, a) > squaredDistance(result.motion, b);
  };
  while (true) {
    result.motion = rigidFit(pairs);
    const auto far = std::size_t(std::count_if(pairs.begin(), pairs.end(), isFar));
    if (far == 0 || pairs.size() <= 3)
      break;
    const std::size_t leave =
        std::clamp<std::size_t>(std::min(far / 2, pairs.size() / 10), 1, pairs.size() - 3);
    std::nth_element(pairs.begin(), pairs.begin() + std::ptrdiff_t(leave), pairs.end(), isWorse);
    pairs.erase(pairs.begin(), pairs.begin() + std::ptrdiff_t(leave));
  }
  for (int round = 0; round < 2; ++round) {
    std::vector<PlacePair> near = all;
    std::erase_if(near, isFar);
    if (near.size() < 3)
      break;
    result.motion = rigidFit(near);
    pairs = std::move(near);
  }
  double sum = 0.0;
  for (const PlacePair& pair : pairs)
    sum += squaredDistance(result.motion, pair);
  result.rmsd = std::sqrt(sum / double(pairs.size()));
  result.kept = pairs.size();
  return result;
}

struct Match {
  const BackboneChain* moving = nullptr;
  const BackboneChain* fixed = nullptr;
  Alignment alignment;
};

Match bestMatch(const Backbone& moving, const Backbone& fixed) {
  Match best;
  std::size_t cells = 0;
  for (const BackboneChain& b : fixed.chains)
    for (const BackboneChain& a : moving.chains) {
      if (a.nucleic != b.nucleic || a.letters.empty())
        continue;
      // Chains twice as good as any found so far may come late in a large assembly, but work has
      // its bounds.
      const std::size_t more = a.letters == b.letters ? 0 : a.letters.size() * b.letters.size();
      if (cells + more > mostCells)
        continue;
      cells += more;
      std::optional<Alignment> alignment = aligned(a.letters, b.letters, a.nucleic);
      if (alignment && (!best.moving || alignment->score > best.alignment.score))
        best = {&a, &b, std::move(*alignment)};
    }
  return best;
}

}  // namespace

RigidMotion rigidFit(std::span<const PlacePair> pairs) {
  RigidMotion motion;
  if (pairs.empty())
    return motion;
  for (const auto& [a, b] : pairs) {
    motion.from += a;
    motion.to += b;
  }
  motion.from /= double(pairs.size());
  motion.to /= double(pairs.size());
  glm::dmat3 s(0.0);  // s[i][k] = Σ aᵢ bₖ
  for (const auto& [a, b] : pairs) {
    const glm::dvec3 p = a - motion.from;
    const glm::dvec3 q = b - motion.to;
    for (int i = 0; i < 3; ++i)
      s[i] += p[i] * q;
  }
  // Horn's matrix N, whose main axis is the quaternion w, x, y, z.
  Symmetric4 n{};
  n[0][0] = s[0][0] + s[1][1] + s[2][2];
  n[1][1] = s[0][0] - s[1][1] - s[2][2];
  n[2][2] = s[1][1] - s[0][0] - s[2][2];
  n[3][3] = s[2][2] - s[0][0] - s[1][1];
  n[0][1] = n[1][0] = s[1][2] - s[2][1];
  n[0][2] = n[2][0] = s[2][0] - s[0][2];
  n[0][3] = n[3][0] = s[0][1] - s[1][0];
  n[1][2] = n[2][1] = s[0][1] + s[1][0];
  n[1][3] = n[3][1] = s[2][0] + s[0][2];
  n[2][3] = n[3][2] = s[1][2] + s[2][1];
  const std::array<double, 4> q = mainAxis(n);
  motion.rotation = glm::mat3_cast(glm::normalize(glm::dquat(q[0], q[1], q[2], q[3])));
  return motion;
}

std::optional<Superposition> superposition(const Backbone& moving, const Backbone& fixed) {
  const Match match = bestMatch(moving, fixed);
  if (!match.moving)
    return std::nullopt;
  const Alignment& alignment = match.alignment;
  if (alignment.pairs.size() < 6 || 4 * alignment.identical < alignment.pairs.size())
    return std::nullopt;
  std::vector<PlacePair> pairs;
  for (const auto& [a, b] : alignment.pairs)
    pairs.emplace_back(match.moving->places[a], match.fixed->places[b]);
  Superposition result = fitted(pairs);
  if (3 * result.kept < result.aligned)
    return std::nullopt;
  result.identity = double(alignment.identical) / double(alignment.pairs.size());
  result.chain = match.moving->id;
  result.ontoChain = match.fixed->id;
  return result;
}

}  // namespace sline::model
