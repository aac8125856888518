// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/superposition.h"

#include <algorithm>
#include <cmath>
#include <gemmi/qcp.hpp>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {

using PlacePair = std::pair<glm::dvec3, glm::dvec3>;
constexpr double nearEnough = 2.0;
constexpr std::size_t mostCells = 400'000'000;

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
      // Chains twice as good as any found so far may come late in a large assembly, but work is
      // bounded.
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
  std::vector<gemmi::Position> moving;
  std::vector<gemmi::Position> fixed;
  for (const auto& [from, to] : pairs) {
    moving.emplace_back(from.x, from.y, from.z);
    fixed.emplace_back(to.x, to.y, to.z);
    motion.from += from / double(pairs.size());
    motion.to += to / double(pairs.size());
  }
  const gemmi::Mat33 turn =
      gemmi::superpose_positions(fixed.data(), moving.data(), pairs.size(), nullptr).transform.mat;
  // Places in a line or in one point leave the rotation undetermined: the determinant is not a
  // number, or not 1.
  if (!(std::abs(turn.determinant() - 1.0) < 1e-6))
    return motion;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      motion.rotation[column][row] = turn[row][column];
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
