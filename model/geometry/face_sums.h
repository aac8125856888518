// SPDX-License-Identifier: Apache-2.0
// Sums at the vertices of a mesh what is found for its faces, four at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "model/base/lanes.h"
#include "model/base/parallel.h"
#include "model/geometry/mesh.h"

namespace sline::model {

template <class T>
using Corners = std::array<T, 3>;

/// Four faces that follow each other; the last one of a mesh may come several times.
struct FourFaces {
  std::size_t number = 0;  ///< counted from 0
  std::array<Triangle, laneCount> vertices;
};

/// What four faces add to the sums of each corner's vertex.
using CornerShares = Corners<std::array<Lanes, laneCount>>;

inline std::size_t foursOf(std::size_t faces) {
  return (faces + laneCount - 1) / laneCount;
}

/// Returns the vectors that `values` has for the faces' vertices of that corner.
template <class Values>
[[gnu::always_inline]] inline Vector<Lanes> cornerVectors(const Values& values,
                                                          const FourFaces& faces,
                                                          std::size_t corner) {
  const glm::vec3& a = values[faces.vertices[0][corner]];
  const glm::vec3& b = values[faces.vertices[1][corner]];
  const glm::vec3& c = values[faces.vertices[2][corner]];
  const glm::vec3& d = values[faces.vertices[3][corner]];
  static_assert(laneCount == 4);
  return {Lanes{a.x, b.x, c.x, d.x}, Lanes{a.y, b.y, c.y, d.y}, Lanes{a.z, b.z, c.z, d.z}};
}

/// Calls body(faces) for each four of the faces from `begin` on, in parallel.
template <class Body>
void forFourFaces(const Mesh& mesh, std::size_t begin, std::size_t count, const Body& body) {
  constexpr std::size_t grain = 512;
  parallelFor(foursOf(count), grain, [&](std::size_t four) {
    FourFaces faces{.number = begin / laneCount + four, .vertices = {}};
    for (std::size_t lane = 0; lane < laneCount; ++lane)
      faces.vertices[lane] = mesh.triangles()[begin + std::min(laneCount * four + lane, count - 1)];
    body(faces);
  });
}
template <class Body>
void forFourFaces(const Mesh& mesh, const Body& body) {
  forFourFaces(mesh, 0, mesh.triangleCount(), body);
}

/// Returns for each vertex the sum of what `sharesOf` returns for its faces, in the order of the
/// faces, whatever threads there are: block by block it is found in parallel, and added in order.
template <class SharesOf>
std::vector<glm::vec4> summedOverFaces(const Mesh& mesh, const SharesOf& sharesOf) {
  constexpr std::size_t blockSize = 16384;
  static_assert(blockSize % laneCount == 0);
  const std::span<const Triangle> triangles = mesh.triangles();
  std::vector<glm::vec4> sums(mesh.vertexCount(), glm::vec4(0.0f));
  std::vector<CornerShares> shares(foursOf(std::min(blockSize, triangles.size())));
  for (std::size_t begin = 0; begin < triangles.size(); begin += blockSize) {
    const std::size_t count = std::min(blockSize, triangles.size() - begin);
    forFourFaces(mesh, begin, count, [&](const FourFaces& faces) {
      const CornerShares found = sharesOf(faces);
      CornerShares& kept = shares[faces.number - begin / laneCount];
      for (std::size_t j = 0; j < found.size(); ++j)
        kept[j] = transposed(found[j]);
    });
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Lanes& share = shares[i / laneCount][j][i % laneCount];
        sums[triangles[begin + i][j]] += glm::vec4(share[0], share[1], share[2], share[3]);
      }
  }
  return sums;
}

}  // namespace sline::model
