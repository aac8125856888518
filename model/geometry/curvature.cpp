// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

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

/// Returns the vector of one tangent plane after the smallest rotation that takes its normal `from`
/// to `to` (Rodrigues; unit normals).
glm::vec3 turned(const glm::vec3& u, const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine <= -0.99999f)
    return -u;
  const glm::vec3 across = to - cosine * from;
  const glm::vec3 along = (from + to) / (1.0f + cosine);
  return u - along * glm::dot(u, across);
}

/// The angle by which one frame of a plane is turned against another one: u = (cosine, sine) there.
struct Turn {
  float cosine;
  float sine;
};

/// Returns how the frame that begins with `u` is turned against `in`, a frame of the same plane.
Turn turnOf(const glm::vec3& u, const Frame& in) {
  return {glm::dot(u, in.u), glm::dot(u, in.v)};
}

/// Returns the tensor in a frame that is turned like that.
Tensor changed(const Tensor& t, const Turn& x) {
  const float mean = 0.5f * (t.x + t.z);
  const float half = 0.5f * (t.x - t.z);
  const float cosine2 = x.cosine * x.cosine - x.sine * x.sine;
  const float sine2 = 2.0f * x.cosine * x.sine;
  const float turnedHalf = cosine2 * half + sine2 * t.y;
  return {mean + turnedHalf, cosine2 * t.y - sine2 * half, mean - turnedHalf};
}

/// Returns C(w1, w2, w3) for vectors given as (first, second) components; C is symmetric.
float applied(const glm::vec4& t, glm::vec2 w1, glm::vec2 w2, glm::vec2 w3) {
  const float xx = w1.x * w2.x;
  const float xy = w1.x * w2.y + w1.y * w2.x;
  const float yy = w1.y * w2.y;
  return (t.x * xx + t.y * xy + t.z * yy) * w3.x + (t.y * xx + t.z * xy + t.w * yy) * w3.y;
}

glm::vec4 changed(const glm::vec4& t, const Turn& x) {
  const glm::vec2 u{x.cosine, x.sine};
  const glm::vec2 v{-x.sine, x.cosine};
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
  glm::vec3 normal;  ///< zero for a face without area
  glm::vec3 areas;   ///< the part of the triangle that belongs to each corner
  bool empty() const { return normal == glm::vec3(0.0f); }
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
  if (!(twiceArea > 0.0f))
    return {};
  return {.normal = cross / twiceArea, .areas = cornerAreas(e, 0.5f * twiceArea)};
}

/// Returns the frame of a face with an area; its first vector is along the edge from corner 1 to
/// corner 2. It is made anew each time, as it would take half as much memory again.
Frame frameOf(const Face& face, const glm::vec3& edge) {
  const glm::vec3 u = edge / glm::length(edge);
  return {u, glm::cross(face.normal, u)};
}

std::vector<Face> makeFaces(const Mesh& mesh) {
  std::vector<Face> faces(mesh.triangleCount());
  parallelFor(faces.size(), 4096,
              [&](std::size_t f) { faces[f] = makeFace(edgesOf(mesh, mesh.triangles()[f])); });
  return faces;
}

/// Returns the tensor that best explains how normals differ along the three edges (R §3).
Tensor faceTensor(const Face& face, const Edges& edges, const std::array<glm::vec3, 3>& normals) {
  const Frame frame = frameOf(face, edges[0]);
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
  const Frame frame = frameOf(face, edges[0]);
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

/// Averages per-face tensors, which `ofFace` returns, at a vertex, weighted by corner areas and
/// written in the frame there that begins with `u`.
template <class T, class OfFace>
T averaged(const Work& work, std::size_t vertex, const OfFace& ofFace, const glm::vec3& u) {
  T sum(0.0f);
  float weights = 0.0f;
  const glm::vec3 normal = work.normals[vertex];
  for (const std::uint32_t f : work.vertexFaces[vertex]) {
    const Face& face = work.faces[f];
    if (face.empty())
      continue;
    const Triangle& t = work.mesh.triangles()[f];
    const float weight = face.areas[t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2];
    const glm::vec3 edge = work.mesh.positions()[t[2]] - work.mesh.positions()[t[1]];
    sum += weight * changed(ofFace(f), turnOf(turned(u, normal, face.normal), frameOf(face, edge)));
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

/// Averages vertex tensors, written in their own tangent frames, over their one-rings. How frames
/// are turned against their neighbours' is found once for all steps.
class RingAverage {
 public:
  explicit RingAverage(const Work& work) : m_first(work.mesh.vertexCount() + 1, 0) {
    const std::size_t count = work.mesh.vertexCount();
    parallelChunks(count, 4096, [&](std::size_t begin, std::size_t end) {
      std::vector<Link> links;
      for (std::size_t v = begin; v < end; ++v)
        m_first[v + 1] = findLinks(work, v, links);
    });
    for (std::size_t v = 0; v < count; ++v)
      m_first[v + 1] += m_first[v];
    m_links.resize(m_first[count]);
    parallelChunks(count, 4096, [&](std::size_t begin, std::size_t end) {
      std::vector<Link> links;
      for (std::size_t v = begin; v < end; ++v) {
        findLinks(work, v, links);
        turn(work, v, links);
        std::copy(links.begin(), links.end(), m_links.begin() + std::ptrdiff_t(m_first[v]));
      }
    });
  }

  std::vector<Tensor> averaged(const std::vector<Tensor>& tensors) const {
    std::vector<Tensor> result(tensors.size());
    parallelFor(tensors.size(), 4096, [&](std::size_t v) {
      Tensor sum = tensors[v];
      float weights = 1.0f;
      for (std::size_t i = m_first[v]; i < m_first[v + 1]; ++i) {
        const Link& link = m_links[i];
        sum += link.weight * changed(tensors[link.vertex], link.turn);
        weights += link.weight;
      }
      result[v] = sum / weights;
    });
    return result;
  }

 private:
  struct Link {
    std::uint32_t vertex;
    float weight;  ///< half of how many triangles share the edge: 1 within a surface
    Turn turn;     ///< of the own frame, in the neighbour's
  };

  /// Returns how many neighbours the vertex has; `links` are these.
  static std::uint32_t findLinks(const Work& work, std::size_t vertex, std::vector<Link>& links) {
    links.clear();
    for (const std::uint32_t f : work.vertexFaces[vertex])
      for (const std::uint32_t w : work.mesh.triangles()[f]) {
        if (w == vertex)
          continue;
        const auto known = std::find_if(links.begin(), links.end(),
                                        [w](const Link& link) { return link.vertex == w; });
        if (known == links.end())
          links.push_back({w, 0.5f, {}});
        else
          known->weight += 0.5f;
      }
    return std::uint32_t(links.size());
  }

  static void turn(const Work& work, std::size_t vertex, std::vector<Link>& links) {
    const glm::vec3 normal = work.normals[vertex];
    const glm::vec3 u = tangentFrame(normal).u;
    for (Link& link : links) {
      const glm::vec3 there = work.normals[link.vertex];
      link.turn = turnOf(turned(u, normal, there), tangentFrame(there));
    }
  }

  std::vector<std::uint32_t> m_first;
  std::vector<Link> m_links;
};

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
    tensors[v] = averaged<Tensor>(
        work, v, [&](std::uint32_t f) { return perFace[f]; }, tangentFrame(work.normals[v]).u);
  });
  return tensors;
}

/// The principal directions and curvatures of all vertices.
struct Principal {
  std::vector<glm::vec3> e1;
  std::vector<glm::vec2> k;
};

Principal principal(const Work& work, const CurvatureOptions& options) {
  const std::size_t count = work.mesh.vertexCount();
  std::vector<Tensor> tensors = vertexTensors(work);
  if (options.smoothingSteps > 0) {
    const RingAverage rings(work);
    for (int step = 0; step < options.smoothingSteps; ++step)
      tensors = rings.averaged(tensors);
  }
  Principal result{.e1 = std::vector<glm::vec3>(count), .k = std::vector<glm::vec2>(count)};
  parallelFor(count, 8192, [&](std::size_t v) {
    diagonalise(tensors[v], tangentFrame(work.normals[v]), result.e1[v], result.k[v]);
  });
  return result;
}

/// Returns the derivative in the frame of a face with an area.
glm::vec4 derivativeOf(std::uint32_t f, const Work& work, const Principal& known) {
  const Triangle& t = work.mesh.triangles()[f];
  const Face& face = work.faces[f];
  const Edges edges = edgesOf(work.mesh, t);
  const glm::vec3 u = frameOf(face, edges[0]).u;
  std::array<Tensor, 3> corners;
  for (std::size_t j = 0; j < 3; ++j) {
    const glm::vec3& normal = work.normals[t[j]];
    const glm::vec3& e1 = known.e1[t[j]];
    const glm::vec2 k = known.k[t[j]];
    const Turn turn = turnOf(turned(u, face.normal, normal), {e1, glm::cross(normal, e1)});
    corners[j] = changed(Tensor(k.x, 0.0f, k.y), turn);
  }
  return faceDerivative(face, edges, corners);
}
}  // namespace

Curvature curvature(const Mesh& mesh, std::span<const glm::vec3> normals,
                    const VertexFaces& vertexFaces, const CurvatureOptions& options) {
  const Work work{mesh, normals, vertexFaces, makeFaces(mesh)};
  Principal known = principal(work, options);
  std::vector<glm::vec4> perFace(work.faces.size(), glm::vec4(0.0f));
  parallelFor(perFace.size(), 4096, [&](std::size_t f) {
    if (!work.faces[f].empty())
      perFace[f] = derivativeOf(std::uint32_t(f), work, known);
  });
  std::vector<glm::vec4> derivative(mesh.vertexCount());
  parallelFor(derivative.size(), 2048, [&](std::size_t v) {
    derivative[v] = averaged<glm::vec4>(
        work, v, [&](std::uint32_t f) { return perFace[f]; }, known.e1[v]);
  });
  return {std::move(known.e1), std::move(known.k), std::move(derivative)};
}

Curvature curvatureAt(std::span<const std::uint32_t> vertices, const Mesh& mesh,
                      std::span<const glm::vec3> normals, const VertexFaces& vertexFaces,
                      const CurvatureOptions& options) {
  const Work work{mesh, normals, vertexFaces, makeFaces(mesh)};
  const Principal known = principal(work, options);
  Curvature result{.e1 = std::vector<glm::vec3>(vertices.size()),
                   .k = std::vector<glm::vec2>(vertices.size()),
                   .derivative = std::vector<glm::vec4>(vertices.size())};
  parallelFor(vertices.size(), 2048, [&](std::size_t i) {
    const std::uint32_t v = vertices[i];
    result.e1[i] = known.e1[v];
    result.k[i] = known.k[v];
    result.derivative[i] = averaged<glm::vec4>(
        work, v, [&](std::uint32_t f) { return derivativeOf(f, work, known); }, known.e1[v]);
  });
  return result;
}

}  // namespace sline::model
