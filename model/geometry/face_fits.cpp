// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/face_fits.h"

#include <array>
#include <cstddef>

#include "model/base/lanes.h"
#include "model/geometry/face_sums.h"
#include "model/geometry/tangent_tensors.h"

namespace sline::model {

namespace {

using Vectors = Vector<Lanes>;
/// What both fits need to know of four faces.
struct Fitted {
  Corners<Vectors> edges;  ///< edges[j] lies opposite corner j
  Corners<Lanes> areas;    ///< the part of the triangle that belongs to each corner
  Vectors normal;
  TangentFrame<Lanes> frame;  ///< begins along edges[0]
  decltype(Lanes{} > 0.0f) hasArea;
};

/// Returns for each corner the area of the part of the triangle nearer to it than to the others
/// (Voronoi area; Meyer et al., "Discrete Differential-Geometry Operators", 2002, but exact for
/// obtuse triangles).
Corners<Lanes> cornerAreas(const Corners<Vectors>& e, Lanes area) {
  const Corners<Lanes> squared{dot(e[0], e[0]), dot(e[1], e[1]), dot(e[2], e[2])};
  // Each entry is the dot product of the two edges that leave a corner.
  const Corners<Lanes> dots{-dot(e[1], e[2]), -dot(e[2], e[0]), -dot(e[0], e[1])};
  // The shares are ⅛·Σ |edge|²·cot(opposite angle), with cot = dot / 2·area.
  Corners<Lanes> shares;
  for (std::size_t j = 0; j < 3; ++j)
    shares[j] = squared[j] * dots[j] / (16.0f * area);
  Corners<Lanes> areas{shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1]};
  for (std::size_t j = 3; j-- > 0;) {
    const std::size_t next = (j + 1) % 3;
    const std::size_t last = (j + 2) % 3;
    const Lanes ofNext = squared[last] * area / (4.0f * dots[next]);
    const Lanes ofLast = squared[next] * area / (4.0f * dots[last]);
    const auto obtuse = dots[j] <= 0.0f;
    areas[next] = obtuse ? ofNext : areas[next];
    areas[last] = obtuse ? ofLast : areas[last];
    areas[j] = obtuse ? area - ofNext - ofLast : areas[j];
  }
  return areas;
}

Fitted fitted(const Mesh& mesh, const FourFaces& faces) {
  const auto p = mesh.positions();
  const Corners<Vectors> at{cornerVectors(p, faces, 0), cornerVectors(p, faces, 1),
                            cornerVectors(p, faces, 2)};
  Fitted f;
  f.edges = {at[2] - at[1], at[0] - at[2], at[1] - at[0]};
  const Vectors across = cross(f.edges[0], f.edges[1]);
  const Lanes twiceArea = squareRoot(dot(across, across));
  f.normal = across / twiceArea;
  // Neither holds where the face is too small or too large for its area to be a number.
  f.hasArea = (twiceArea > 0.0f) & (dot(f.normal, f.normal) > 0.0f);
  f.areas = cornerAreas(f.edges, 0.5f * twiceArea);
  f.frame.u = f.edges[0] / squareRoot(dot(f.edges[0], f.edges[0]));
  f.frame.v = cross(f.normal, f.frame.u);
  return f;
}

/// Solves A·x = b in place by LDLᵀ for a symmetric positive definite A that has entries on its
/// diagonal and beside it alone; where A is singular, x = 0.
template <std::size_t N>
void solve(std::array<Lanes, N> diagonal, std::array<Lanes, N - 1> beside,
           std::array<Lanes, N>& b) {
  auto definite = diagonal[0] > 0.0f;
  for (std::size_t i = 1; i < N; ++i) {
    beside[i - 1] /= diagonal[i - 1];
    diagonal[i] -= beside[i - 1] * beside[i - 1] * diagonal[i - 1];
    definite &= diagonal[i] > 0.0f;
    b[i] -= beside[i - 1] * b[i - 1];
  }
  b[N - 1] /= diagonal[N - 1];
  for (std::size_t i = N - 1; i-- > 0;)
    b[i] = b[i] / diagonal[i] - beside[i] * b[i + 1];
  for (Lanes& x : b)
    x = definite ? x : Lanes{};
}

/// Returns the faces' tensors, in their frames.
TangentTensor<Lanes> faceTensor(const Fitted& f, const Corners<Vectors>& normals) {
  Lanes xx{}, xy{}, yy{};
  std::array<Lanes, 3> b{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes x = dot(f.edges[j], f.frame.u);
    const Lanes y = dot(f.edges[j], f.frame.v);
    const Vectors change = normals[(j + 2) % 3] - normals[(j + 1) % 3];
    const Lanes du = dot(change, f.frame.u);
    const Lanes dv = dot(change, f.frame.v);
    xx += x * x;
    xy += x * y;
    yy += y * y;
    b[0] += du * x;
    b[1] += du * y + dv * x;
    b[2] += dv * y;
  }
  solve<3>({xx, xx + yy, yy}, {xy, xy}, b);
  return {b[0], b[1], b[2]};
}

/// Returns the faces' derivatives, in their frames, given the corners' tensors in them.
TangentDerivative<Lanes> faceDerivative(const Fitted& f,
                                        const Corners<TangentTensor<Lanes>>& corners) {
  Lanes xx{}, xy{}, yy{};
  std::array<Lanes, 4> b{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes x = dot(f.edges[j], f.frame.u);
    const Lanes y = dot(f.edges[j], f.frame.v);
    const TangentTensor<Lanes>& to = corners[(j + 2) % 3];
    const TangentTensor<Lanes>& from = corners[(j + 1) % 3];
    const Lanes uu = to.uu - from.uu;
    const Lanes uv = to.uv - from.uv;
    const Lanes vv = to.vv - from.vv;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    b[0] += x * uu;
    b[1] += y * uu + 2.0f * x * uv;
    b[2] += 2.0f * y * uv + x * vv;
    b[3] += y * vv;
  }
  // The mixed entry occurs twice in the tensor, so it counts twice.
  solve<4>({xx, 2.0f * xx + yy, xx + 2.0f * yy, yy}, {xy, 2.0f * xy, xy}, b);
  return {b[0], b[1], b[2], b[3]};
}

CornerShares tensorShares(const Mesh& mesh, std::span<const glm::vec3> normals,
                          const FourFaces& faces) {
  const Fitted f = fitted(mesh, faces);
  const Corners<Vectors> n{cornerVectors(normals, faces, 0), cornerVectors(normals, faces, 1),
                           cornerVectors(normals, faces, 2)};
  const TangentTensor<Lanes> tensor = faceTensor(f, n);
  CornerShares shares;
  for (std::size_t j = 0; j < 3; ++j) {
    const Turn<Lanes> turn = turnOf(turned(tangentFrame(n[j]).u, n[j], f.normal), f.frame);
    const TangentTensor<Lanes> there = changed(tensor, turn);
    const Lanes weight = f.areas[j];
    shares[j] = {there.uu * weight, there.uv * weight, there.vv * weight, weight};
  }
  for (std::array<Lanes, 4>& share : shares)
    for (Lanes& number : share)
      number = f.hasArea ? number : Lanes{};
  return shares;
}

CornerShares derivativeShares(const Mesh& mesh, std::span<const glm::vec3> normals,
                              const Principal& known, const FourFaces& faces) {
  const Fitted f = fitted(mesh, faces);
  Corners<Turn<Lanes>> turns;  // of the face's frame, in the vertex's
  Corners<TangentTensor<Lanes>> tensors;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vectors normal = cornerVectors(normals, faces, j);
    const Vectors e1 = cornerVectors(known.e1, faces, j);
    const std::array<glm::vec2, laneCount> k{
        known.k[faces.vertices[0][j]], known.k[faces.vertices[1][j]], known.k[faces.vertices[2][j]],
        known.k[faces.vertices[3][j]]};
    const TangentTensor<Lanes> own{Lanes{k[0].x, k[1].x, k[2].x, k[3].x}, Lanes{},
                                   Lanes{k[0].y, k[1].y, k[2].y, k[3].y}};
    turns[j] = turnOf(turned(f.frame.u, f.normal, normal), {e1, cross(normal, e1)});
    tensors[j] = changed(own, turns[j]);
  }
  const TangentDerivative<Lanes> derivative = faceDerivative(f, tensors);
  CornerShares shares;
  for (std::size_t j = 0; j < 3; ++j) {
    const TangentDerivative<Lanes> there = changed(derivative, turns[j].back());
    const Lanes weight = f.areas[j];
    shares[j] = {there.uuu * weight, there.uuv * weight, there.uvv * weight, there.vvv * weight};
  }
  for (std::array<Lanes, 4>& share : shares)
    for (Lanes& number : share)
      number = f.hasArea ? number : Lanes{};
  return shares;
}

}  // namespace

std::vector<glm::vec4> summedTensors(const Mesh& mesh, std::span<const glm::vec3> normals) {
  return summedOverFaces(
      mesh, [&](const FourFaces& faces) { return tensorShares(mesh, normals, faces); });
}

std::vector<glm::vec4> summedDerivatives(const Mesh& mesh, std::span<const glm::vec3> normals,
                                         const Principal& known) {
  return summedOverFaces(
      mesh, [&](const FourFaces& faces) { return derivativeShares(mesh, normals, known, faces); });
}

}  // namespace sline::model
