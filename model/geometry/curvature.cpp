// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/curvature.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
/// Two unit vectors span a plane with the normal u × v.
struct Frame {
  glm::vec3 u;
  glm::vec3 v;
};

/// Holds a symmetric 2×2 tensor in some frame: (uu, uv, vv).
using Tensor = glm::vec3;

/// Returns a tangent frame of a unit normal, without branches that jump nearby (Duff et al.,
/// "Building an Orthonormal Basis, Revisited", JCGT 2017).
Frame tangentFrame(const glm::vec3& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// Returns the frame after the smallest rotation that takes `from` to `to` (Rodrigues; unit
/// normals).
Frame turned(const Frame& frame, const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine <= -0.99999f)
    return {-frame.u, -frame.v};
  const glm::vec3 across = to - cosine * from;
  const glm::vec3 along = (from + to) / (1.0f + cosine);
  return {frame.u - along * glm::dot(frame.u, across), frame.v - along * glm::dot(frame.v, across)};
}

/// Holds the axes of one frame written in another frame of the same plane: u = (a, b), v = (c, d).
struct Axes {
  float a, b, c, d;
};

Axes axes(const Frame& of, const Frame& in) {
  return {glm::dot(of.u, in.u), glm::dot(of.u, in.v), glm::dot(of.v, in.u), glm::dot(of.v, in.v)};
}

Tensor changed(const Tensor& t, const Axes& x) {
  return {t.x * x.a * x.a + 2.0f * t.y * x.a * x.b + t.z * x.b * x.b,
          t.x * x.a * x.c + t.y * (x.a * x.d + x.b * x.c) + t.z * x.b * x.d,
          t.x * x.c * x.c + 2.0f * t.y * x.c * x.d + t.z * x.d * x.d};
}

/// Returns C(w1, w2, w3) for vectors given as (first, second) components; C is symmetric.
float applied(const glm::vec4& t, glm::vec2 w1, glm::vec2 w2, glm::vec2 w3) {
  const float xx = w1.x * w2.x;
  const float xy = w1.x * w2.y + w1.y * w2.x;
  const float yy = w1.y * w2.y;
  return (t.x * xx + t.y * xy + t.z * yy) * w3.x + (t.y * xx + t.z * xy + t.w * yy) * w3.y;
}

glm::vec4 changed(const glm::vec4& t, const Axes& x) {
  const glm::vec2 u{x.a, x.b};
  const glm::vec2 v{x.c, x.d};
  return {applied(t, u, u, u), applied(t, u, u, v), applied(t, u, v, v), applied(t, v, v, v)};
}

/// Solves A·x = b in place for a symmetric positive definite A by LDLᵀ; returns false where A is
/// singular.
template <std::size_t N>
bool solve(std::array<std::array<float, N>, N>& a, std::array<float, N>& b) {
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      a[i][i] -= a[i][k] * a[i][k] * a[k][k];
    if (!(a[i][i] > 0.0f))
      return false;
    for (std::size_t j = i + 1; j < N; ++j) {
      for (std::size_t k = 0; k < i; ++k)
        a[j][i] -= a[j][k] * a[i][k] * a[k][k];
      a[j][i] /= a[i][i];
    }
  }
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < i; ++k)
      b[i] -= a[i][k] * b[k];
  for (std::size_t i = N; i-- > 0;) {
    b[i] /= a[i][i];
    for (std::size_t k = i + 1; k < N; ++k)
      b[i] -= a[k][i] * b[k];
  }
  return true;
}

/// Holds the values of a triangle that both estimates need; computed once, read from each of its
/// vertices.
struct Face {
  glm::vec3 u;  ///< along the edge from corner 1 to corner 2; zero for a face without area
  glm::vec3 normal;
  glm::vec3 areas;  ///< the part of the triangle that belongs to each corner
  Frame frame() const { return {u, glm::cross(normal, u)}; }
  bool empty() const { return u == glm::vec3(0.0f); }
};

using Edges = std::array<glm::vec3, 3>;

/// Returns the edges; edges[j] lies opposite corner j.
Edges edgesOf(const Mesh& mesh, const Triangle& t) {
  const auto p = mesh.positions();
  return {p[t[2]] - p[t[1]], p[t[0]] - p[t[2]], p[t[1]] - p[t[0]]};
}

/// Returns for each corner the area of the part of the triangle nearer to it than to the others
/// (Voronoi area; Meyer et al., "Discrete Differential-Geometry Operators", 2002, but exact for
/// obtuse triangles).
glm::vec3 cornerAreas(const Edges& e, float area) {
  const glm::vec3 squared{glm::dot(e[0], e[0]), glm::dot(e[1], e[1]), glm::dot(e[2], e[2])};
  // Each entry is the dot product of the two edges that leave a corner.
  const glm::vec3 dots{-glm::dot(e[1], e[2]), -glm::dot(e[2], e[0]), -glm::dot(e[0], e[1])};
  for (glm::length_t j = 0; j < 3; ++j) {
    if (dots[j] > 0.0f)
      continue;
    const glm::length_t next = (j + 1) % 3;
    const glm::length_t last = (j + 2) % 3;
    glm::vec3 areas(0.0f);
    areas[next] = squared[last] * area / (4.0f * dots[next]);
    areas[last] = squared[next] * area / (4.0f * dots[last]);
    areas[j] = area - areas[next] - areas[last];
    return areas;
  }
  // The shares are ⅛·Σ |edge|²·cot(opposite angle), with cot = dot / 2·area.
  const glm::vec3 shares = squared * dots / (16.0f * area);
  return {shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1]};
}

Face makeFace(const Edges& e) {
  const glm::vec3 cross = glm::cross(e[0], e[1]);
  const float twiceArea = glm::length(cross);
  const float length = glm::length(e[0]);
  if (!(twiceArea > 0.0f) || !(length > 0.0f))
    return {};
  return {
      .u = e[0] / length, .normal = cross / twiceArea, .areas = cornerAreas(e, 0.5f * twiceArea)};
}

std::vector<Face> makeFaces(const Mesh& mesh) {
  std::vector<Face> faces(mesh.triangleCount());
  parallelFor(faces.size(), 4096,
              [&](std::size_t f) { faces[f] = makeFace(edgesOf(mesh, mesh.triangles()[f])); });
  return faces;
}

/// Returns the tensor that best explains how normals differ along the three edges (R §3).
Tensor faceTensor(const Face& face, const Edges& edges, const std::array<glm::vec3, 3>& normals) {
  const Frame frame = face.frame();
  std::array<std::array<float, 3>, 3> a{};
  std::array<float, 3> b{};
  for (std::size_t j = 0; j < 3; ++j) {
    const glm::vec2 e{glm::dot(edges[j], frame.u), glm::dot(edges[j], frame.v)};
    const glm::vec3 change = normals[(j + 2) % 3] - normals[(j + 1) % 3];
    const float du = glm::dot(change, frame.u);
    const float dv = glm::dot(change, frame.v);
    a[0][0] += e.x * e.x;
    a[1][0] += e.x * e.y;
    a[2][2] += e.y * e.y;
    b[0] += du * e.x;
    b[1] += du * e.y + dv * e.x;
    b[2] += dv * e.y;
  }
  a[1][1] = a[0][0] + a[2][2];
  a[2][1] = a[1][0];
  return solve(a, b) ? Tensor(b[0], b[1], b[2]) : Tensor(0.0f);
}

/// Returns the derivative that best explains how the corners' tensors, turned into the face, differ
/// (R §4): the same fit one order higher.
glm::vec4 faceDerivative(const Face& face, const Edges& edges,
                         const std::array<Tensor, 3>& corners) {
  const Frame frame = face.frame();
  std::array<std::array<float, 4>, 4> a{};
  std::array<float, 4> b{};
  for (std::size_t j = 0; j < 3; ++j) {
    const glm::vec2 e{glm::dot(edges[j], frame.u), glm::dot(edges[j], frame.v)};
    const Tensor change = corners[(j + 2) % 3] - corners[(j + 1) % 3];
    a[0][0] += e.x * e.x;
    a[1][0] += e.x * e.y;
    a[3][3] += e.y * e.y;
    b[0] += e.x * change.x;
    b[1] += e.y * change.x + 2.0f * e.x * change.y;
    b[2] += 2.0f * e.y * change.y + e.x * change.z;
    b[3] += e.y * change.z;
  }
  // The mixed entry occurs twice in the tensor, so it counts twice.
  a[1][1] = 2.0f * a[0][0] + a[3][3];
  a[2][1] = 2.0f * a[1][0];
  a[2][2] = a[0][0] + 2.0f * a[3][3];
  a[3][2] = a[1][0];
  return solve(a, b) ? glm::vec4(b[0], b[1], b[2], b[3]) : glm::vec4(0.0f);
}

/// Holds the mesh and the results computed from it so far.
struct Work {
  const Mesh& mesh;
  std::span<const glm::vec3> normals;
  const VertexFaces& vertexFaces;
  std::vector<Face> faces;
};

/// Averages per-face tensors at a vertex, weighted by corner areas and written in `frame`.
template <class T>
T averaged(const Work& work, std::size_t vertex, const std::vector<T>& perFace,
           const Frame& frame) {
  T sum(0.0f);
  float weights = 0.0f;
  const glm::vec3 normal = work.normals[vertex];
  for (const std::uint32_t f : work.vertexFaces[vertex]) {
    const Face& face = work.faces[f];
    if (face.empty())
      continue;
    const Triangle& t = work.mesh.triangles()[f];
    const float weight = face.areas[t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2];
    sum += weight * changed(perFace[f], axes(turned(frame, normal, face.normal), face.frame()));
    weights += weight;
  }
  return weights > 0.0f ? sum / weights : T(0.0f);
}

/// Turns the frame within its plane so that the tensor becomes diagonal, with the larger |κ| first.
void diagonalise(const Tensor& t, const Frame& frame, glm::vec3& e1, glm::vec2& k) {
  const float mean = 0.5f * (t.x + t.z);
  const float half = 0.5f * (t.x - t.z);
  const float radius = std::hypot(half, t.y);
  // The larger |κ| is mean ± radius, and e1 is the eigenvector of that sign.
  const float sign = mean < 0.0f ? -1.0f : 1.0f;
  k = {mean + sign * radius, mean - sign * radius};
  // This is half the angle of (half, uv), computed on the side that loses no digits.
  const float x = sign * half;
  const float y = sign * t.y;
  glm::vec2 d =
      x >= 0.0f ? glm::vec2(radius + x, y) : glm::vec2(std::abs(y), std::copysign(radius - x, y));
  const float length = glm::length(d);
  d = length > 0.0f ? d / length : glm::vec2(1.0f, 0.0f);
  e1 = d.x * frame.u + d.y * frame.v;
}

/// Averages the vertex tensors (written in their own tangent frames) over the one-ring once.
std::vector<Tensor> smoothed(const Work& work, const std::vector<Tensor>& tensors) {
  std::vector<Tensor> result(tensors.size());
  parallelFor(tensors.size(), 2048, [&](std::size_t v) {
    const glm::vec3 normal = work.normals[v];
    const Frame own = tangentFrame(normal);
    Tensor sum = tensors[v];
    float count = 1.0f;
    for (const std::uint32_t f : work.vertexFaces[v])
      for (const std::uint32_t w : work.mesh.triangles()[f])
        if (w != v) {
          const glm::vec3 there = work.normals[w];
          // Each neighbour of an inner vertex occurs in two faces.
          sum += 0.5f * changed(tensors[w], axes(turned(own, normal, there), tangentFrame(there)));
          count += 0.5f;
        }
    result[v] = sum / count;
  });
  return result;
}

std::vector<Tensor> vertexTensors(const Work& work) {
  std::vector<Tensor> perFace(work.faces.size());
  parallelFor(perFace.size(), 4096, [&](std::size_t f) {
    const Triangle& t = work.mesh.triangles()[f];
    perFace[f] = work.faces[f].empty()
                     ? Tensor(0.0f)
                     : faceTensor(work.faces[f], edgesOf(work.mesh, t),
                                  {work.normals[t[0]], work.normals[t[1]], work.normals[t[2]]});
  });
  std::vector<Tensor> tensors(work.mesh.vertexCount());
  parallelFor(tensors.size(), 2048, [&](std::size_t v) {
    tensors[v] = averaged(work, v, perFace, tangentFrame(work.normals[v]));
  });
  return tensors;
}

void addDerivative(Curvature& curvature, const Work& work) {
  const auto frameAt = [&](std::size_t v) {
    return Frame{curvature.e1[v], glm::cross(work.normals[v], curvature.e1[v])};
  };
  std::vector<glm::vec4> perFace(work.faces.size(), glm::vec4(0.0f));
  parallelFor(perFace.size(), 4096, [&](std::size_t f) {
    const Triangle& t = work.mesh.triangles()[f];
    const Face& face = work.faces[f];
    if (face.empty())
      return;
    const Frame frame = face.frame();
    std::array<Tensor, 3> corners;
    for (std::size_t j = 0; j < 3; ++j) {
      const glm::vec2 k = curvature.k[t[j]];
      const Frame atCorner = turned(frame, face.normal, work.normals[t[j]]);
      corners[j] = changed(Tensor(k.x, 0.0f, k.y), axes(atCorner, frameAt(t[j])));
    }
    perFace[f] = faceDerivative(face, edgesOf(work.mesh, t), corners);
  });
  parallelFor(work.mesh.vertexCount(), 2048, [&](std::size_t v) {
    curvature.derivative[v] = averaged(work, v, perFace, frameAt(v));
  });
}
}  // namespace

Curvature curvature(const Mesh& mesh, std::span<const glm::vec3> normals,
                    const VertexFaces& vertexFaces, const CurvatureOptions& options) {
  const Work work{mesh, normals, vertexFaces, makeFaces(mesh)};
  std::vector<Tensor> tensors = vertexTensors(work);
  for (int step = 0; step < options.smoothingSteps; ++step)
    tensors = smoothed(work, tensors);
  Curvature result{.e1 = std::vector<glm::vec3>(mesh.vertexCount()),
                   .k = std::vector<glm::vec2>(mesh.vertexCount()),
                   .derivative = std::vector<glm::vec4>(mesh.vertexCount())};
  parallelFor(mesh.vertexCount(), 8192, [&](std::size_t v) {
    diagonalise(tensors[v], tangentFrame(normals[v]), result.e1[v], result.k[v]);
  });
  tensors = {};
  addDerivative(result, work);
  return result;
}

}  // namespace sline::model
