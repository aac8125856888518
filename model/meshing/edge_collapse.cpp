// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/edge_collapse.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <queue>
#include <tuple>

#include "model/fairing/half_edges.h"
#include "model/meshing/cut_surface.h"

namespace sline::model {

namespace {
constexpr std::uint32_t none = 0xffffffffu;

struct CollapseTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
};
using CollapseMesh = OpenMesh::TriMesh_ArrayKernelT<CollapseTraits>;
using Vertex = CollapseMesh::VertexHandle;
using HalfEdge = CollapseMesh::HalfedgeHandle;
using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<CollapseMesh>;
using Module = OpenMesh::Decimater::ModBaseT<CollapseMesh>;
constexpr float refused = Module::ILLEGAL_COLLAPSE;
constexpr float allowed = Module::LEGAL_COLLAPSE;

std::size_t indexOf(Vertex v) {
  return std::size_t(v.idx());
}

glm::dvec3 placeOf(const CollapseMesh& mesh, Vertex v) {
  const OpenMesh::Vec3d& p = mesh.point(v);
  return {p[0], p[1], p[2]};
}

void place(CollapseMesh& mesh, Vertex v, const glm::dvec3& p) {
  mesh.set_point(v, {p.x, p.y, p.z});
}

/// Builds the cut surface from the half-edges that are known already: add_face() would search for
/// them again, and takes three times as long. Vertices at rims and cuts are locked.
CollapseMesh collapseMesh(const Mesh& surface, const CutSurface& cut, const glm::dvec3& centre) {
  CollapseMesh mesh;
  mesh.reserve(cut.originals.size(), cut.corners.size() / 2, surface.triangleCount());
  for (std::uint32_t v = 0; v < cut.originals.size(); ++v) {
    const Vertex vertex = mesh.new_vertex();
    place(mesh, vertex, glm::dvec3(surface.positions()[cut.originals[v]]) - centre);
    mesh.status(vertex).set_locked(cut.rims[v] || cut.isCopied(v));
  }
  const auto corner = [&](std::uint32_t h) { return Vertex(int(cut.corners[h])); };
  std::vector<HalfEdge> edges(cut.corners.size());
  std::vector<HalfEdge> rims(cut.originals.size());  // by the vertex at which they start
  for (std::uint32_t h = 0; h < edges.size(); ++h) {
    const std::uint32_t other = cut.opposites[h];
    if (other < h) {
      edges[h] = mesh.opposite_halfedge_handle(edges[other]);
      continue;
    }
    const Vertex to = corner(nextInTriangle(h));
    edges[h] = mesh.new_edge(corner(h), to);
    if (other == HalfEdges::open)
      rims[indexOf(to)] = mesh.opposite_halfedge_handle(edges[h]);
  }
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
    const CollapseMesh::FaceHandle face = mesh.new_face();
    mesh.set_halfedge_handle(face, edges[std::size_t(3) * t]);
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      mesh.set_next_halfedge_handle(edges[h], edges[nextInTriangle(h)]);
      mesh.set_face_handle(edges[h], face);
      mesh.set_halfedge_handle(corner(h), edges[h]);
    }
  }
  for (const HalfEdge rim : rims) {
    if (!rim.is_valid())
      continue;
    mesh.set_halfedge_handle(mesh.from_vertex_handle(rim), rim);
    mesh.set_next_halfedge_handle(rim, rims[indexOf(mesh.to_vertex_handle(rim))]);
  }
  return mesh;
}

/// Holds Σ area · (n·p + d)² as a polynomial in p.
struct Quadric {
  glm::dmat3 a{0.0};
  glm::dvec3 b{0.0};
  double c = 0.0;
  double area = 0.0;

  void add(const glm::dvec3& normal, double offset, double weight) {
    for (glm::length_t i = 0; i < 3; ++i)
      a[i] += weight * normal[i] * normal;
    b += weight * offset * normal;
    c += weight * offset * offset;
    area += weight;
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    area += other.area;
    return *this;
  }
  /// Returns the root mean square distance from the planes.
  double distance(const glm::dvec3& p) const {
    const double sum = glm::dot(p, a * p) + 2.0 * glm::dot(b, p) + c;
    return area > 0.0 ? std::sqrt(std::max(0.0, sum) / area) : 0.0;
  }
  /// Returns the best place or, where the planes leave it open, the best one nearest to `near`.
  glm::dvec3 best(const glm::dvec3& near) const {
    const double weak = 1e-3 * area + 1e-30;
    const glm::dmat3 held = a + glm::dmat3(weak);
    return glm::inverse(held) * (weak * near - b);
  }
};

/// Computes the cost of an edge and the place of its vertex: OpenMesh's own ModQuadricT leaves the
/// vertex at one end of the edge, which takes 20 to 50 % more triangles for the same bound, and
/// knows no tolerances.
class QuadricModule : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<QuadricModule>;

  explicit QuadricModule(CollapseMesh& mesh) : Module(mesh, false) {}

  /// Sets one tolerance for each vertex of the mesh.
  void setTolerances(std::vector<float> tolerances) { m_tolerances = std::move(tolerances); }

  void initialize() override {
    m_quadrics.assign(mesh().n_vertices(), {});
    for (const auto face : mesh().faces()) {
      std::array<Vertex, 3> corners;
      std::copy_n(mesh().cfv_iter(face), 3, corners.begin());
      const glm::dvec3 p = placeOf(mesh(), corners[0]);
      const glm::dvec3 cross =
          glm::cross(placeOf(mesh(), corners[1]) - p, placeOf(mesh(), corners[2]) - p);
      const double twice = glm::length(cross);
      if (!(twice > 0.0))
        continue;
      const glm::dvec3 normal = cross / twice;
      for (const Vertex v : corners)
        m_quadrics[indexOf(v)].add(normal, -glm::dot(normal, p), 0.5 * twice);
    }
  }

  float collapse_priority(const CollapseInfo& info) override {
    const double distance = together(info).distance(target(info));
    return distance <= double(tolerance(info)) ? float(distance) : refused;
  }

  void preprocess_collapse(const CollapseInfo& info) override { m_target = target(info); }

  void postprocess_collapse(const CollapseInfo& info) override {
    m_tolerances[indexOf(info.v1)] = tolerance(info);
    m_quadrics[indexOf(info.v1)] = together(info);
    place(mesh(), info.v1, m_target);
  }

  /// Returns the place to which the remaining vertex would move.
  glm::dvec3 target(const CollapseInfo& info) {
    const glm::dvec3 kept = placeOf(mesh(), info.v1);
    if (mesh().status(info.v1).locked())
      return kept;
    return together(info).best(0.5 * (placeOf(mesh(), info.v0) + kept));
  }

 private:
  Quadric together(const CollapseInfo& info) const {
    Quadric both = m_quadrics[indexOf(info.v0)];
    both += m_quadrics[indexOf(info.v1)];
    return both;
  }
  float tolerance(const CollapseInfo& info) const {
    return std::min(m_tolerances[indexOf(info.v0)], m_tolerances[indexOf(info.v1)]);
  }

  std::vector<Quadric> m_quadrics;
  std::vector<float> m_tolerances;
  glm::dvec3 m_target{0.0};
};

/// Returns 1 for an equilateral triangle, 0 for one without area.
double roundness(const std::array<glm::dvec3, 3>& p, double twiceArea) {
  const glm::dvec3 e[] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const double squares = glm::dot(e[0], e[0]) + glm::dot(e[1], e[1]) + glm::dot(e[2], e[2]);
  return squares > 0.0 ? 2.0 * std::sqrt(3.0) * twiceArea / squares : 0.0;
}

/// Checks the triangles around both vertices that remain: turned by more than 75° or made needles,
/// they would be visible. ModNormalFlippingT and ModAspectRatioT judge a vertex that stays where it
/// was.
class ShapeModule : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ShapeModule>;

  explicit ShapeModule(CollapseMesh& mesh) : Module(mesh, true) {}

  void setPlaces(QuadricModule& places) { m_places = &places; }

  float collapse_priority(const CollapseInfo& info) override {
    const glm::dvec3 target = m_places->target(info);
    return spoils(info.v0, info.v1, target) || spoils(info.v1, info.v0, target) ? refused : allowed;
  }

 private:
  bool spoils(Vertex moved, Vertex other, const glm::dvec3& target) {
    const glm::dvec3 from = placeOf(mesh(), moved);
    for (auto spoke = mesh().cvoh_iter(moved); spoke.is_valid(); ++spoke) {
      const Vertex a = mesh().to_vertex_handle(*spoke);
      const Vertex b = mesh().to_vertex_handle(mesh().next_halfedge_handle(*spoke));
      if (mesh().is_boundary(*spoke) || a == other || b == other)
        continue;
      std::array<glm::dvec3, 3> p{from, placeOf(mesh(), a), placeOf(mesh(), b)};
      const glm::dvec3 before = glm::cross(p[1] - p[0], p[2] - p[0]);
      const double roundBefore = roundness(p, glm::length(before));
      p[0] = target;
      const glm::dvec3 after = glm::cross(p[1] - p[0], p[2] - p[0]);
      const double roundAfter = roundness(p, glm::length(after));
      if (glm::dot(before, after) < 0.25 * glm::length(before) * glm::length(after) ||
          !(roundAfter > std::min(0.1, 0.5 * roundBefore)))
        return true;
    }
    return false;
  }

  QuadricModule* m_places = nullptr;
};

/// Checks the link condition where the surface was cut, which OpenMesh's own test does not know: no
/// new edge may join the originals of two vertices that another edge joins already.
class SeamModule : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<SeamModule>;

  explicit SeamModule(CollapseMesh& mesh) : Module(mesh, true) {}

  void setCut(const CutSurface& cut) { m_cut = &cut; }

  float collapse_priority(const CollapseInfo& info) override {
    if (!isNearCopies(info.v0) && !isNearCopies(info.v1))
      return allowed;
    const std::vector<std::uint32_t> gone = neighbours(info.v0);
    const std::vector<std::uint32_t> kept = neighbours(info.v1);
    std::vector<std::uint32_t> common;
    std::set_intersection(gone.begin(), gone.end(), kept.begin(), kept.end(),
                          std::back_inserter(common));
    return common.size() == 2 ? allowed : refused;
  }

 private:
  bool isNearCopies(Vertex v) {
    const auto isCopied = [&](Vertex w) { return m_cut->isCopied(std::uint32_t(w.idx())); };
    const auto ring = mesh().vv_range(v);
    return isCopied(v) || std::any_of(ring.begin(), ring.end(), isCopied);
  }

  /// Returns the neighbours of all copies of the vertex, as originals, ascending.
  std::vector<std::uint32_t> neighbours(Vertex v) {
    std::vector<std::uint32_t> ring;
    const auto first = std::uint32_t(v.idx());
    std::uint32_t copy = first;
    do {
      for (const auto other : mesh().vv_range(Vertex(int(copy))))
        ring.push_back(m_cut->originals[indexOf(other)]);
      copy = m_cut->copies[copy];
    } while (copy != first);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  const CutSurface* m_cut = nullptr;
};

/// Takes the cheapest of all edges each time. OpenMesh's own DecimaterT keeps the best edge of each
/// vertex instead and looks again at the vertices around the removed one: it assumes that the other
/// stays where it is, and asks all modules about each of some forty edges after every step.
class EdgeDecimater : public OpenMesh::Decimater::BaseDecimaterT<CollapseMesh> {
 public:
  using BaseDecimaterT::BaseDecimaterT;

  /// Returns false where `goesOn` returned false.
  bool decimate(QuadricModule& costs, const CutSurface& cut, const std::function<bool()>& goesOn) {
    m_versions.assign(mesh().n_edges(), 0);
    for (const auto edge : mesh().edges())
      offer(mesh().halfedge_handle(edge, 0), costs);
    for (std::size_t step = 0; !m_queue.empty(); ++step) {
      if (step % 4096 == 0 && !goesOn())
        return false;
      const Candidate next = m_queue.top();
      m_queue.pop();
      const CollapseMesh::EdgeHandle edge = mesh().edge_handle(HalfEdge(next.halfEdge));
      if (mesh().status(edge).deleted() || m_versions[std::size_t(edge.idx())] != next.version)
        continue;
      CollapseInfo info(mesh(), HalfEdge(next.halfEdge));
      if (isCrowded(info.v0, cut) || isCrowded(info.v1, cut) || !is_collapse_legal(info) ||
          collapse_priority(info) < 0.0f)
        continue;
      preprocess_collapse(info);
      mesh().collapse(info.v0v1);
      postprocess_collapse(info);
      for (const auto spoke : mesh().voh_range(info.v1))
        offer(spoke, costs);
    }
    return true;
  }

 private:
  struct Candidate {
    float cost;
    int halfEdge;           ///< from the vertex that is removed to the one that remains
    std::uint32_t version;  ///< version of the edge when it was offered
    bool operator<(const Candidate& other) const {
      // The queue hands out the largest; ties go by number, so that the result is always the same.
      return std::tie(cost, halfEdge) > std::tie(other.cost, other.halfEdge);
    }
  };

  /// Tells whether so many edges meet at the vertex and its copies that to look at all of them for
  /// each would take too long. Such a vertex keeps its edges until others take some away.
  bool isCrowded(Vertex v, const CutSurface& cut) {
    constexpr int most = 256;
    int count = 0;
    const auto first = std::uint32_t(v.idx());
    std::uint32_t copy = first;
    do {
      for (auto spoke = mesh().cvoh_iter(Vertex(int(copy))); spoke.is_valid(); ++spoke)
        if (++count > most)
          return true;
      copy = cut.copies[copy];
    } while (copy != first);
    return false;
  }

  /// Offers an edge at its quadric cost. The other modules are asked only when its turn comes,
  /// since most edges change before.
  void offer(HalfEdge halfEdge, QuadricModule& costs) {
    if (mesh().status(mesh().from_vertex_handle(halfEdge)).locked())
      halfEdge = mesh().opposite_halfedge_handle(halfEdge);
    if (mesh().status(mesh().from_vertex_handle(halfEdge)).locked())
      return;
    const std::uint32_t version = ++m_versions[std::size_t(mesh().edge_handle(halfEdge).idx())];
    const float cost = costs.collapse_priority(CollapseInfo(mesh(), halfEdge));
    if (cost >= 0.0f)
      m_queue.push({cost, halfEdge.idx(), version});
  }

  std::vector<std::uint32_t> m_versions;  ///< for each edge, how often it was offered
  std::priority_queue<Candidate> m_queue;
};

/// Merges the copies of each vertex again.
Collapsed sewn(const CollapseMesh& mesh, const CutSurface& cut, const glm::dvec3& centre,
               std::size_t vertexCount) {
  Collapsed out;
  std::vector<std::uint32_t> index(vertexCount, none);
  for (const auto face : mesh.faces()) {
    if (mesh.status(face).deleted())
      continue;
    Triangle triangle{};
    auto corner = triangle.begin();
    for (const auto vertex : mesh.fv_range(face)) {
      std::uint32_t& v = index[cut.originals[indexOf(vertex)]];
      if (v == none) {
        v = std::uint32_t(out.positions.size());
        out.positions.push_back(glm::vec3(placeOf(mesh, vertex) + centre));
      }
      *corner++ = v;
    }
    out.triangles.push_back(triangle);
  }
  return out;
}
}  // namespace

Collapsed withEdgesCollapsed(const Mesh& mesh, std::span<const float> tolerances,
                             const std::function<bool()>& goesOn) {
  if (mesh.triangleCount() == 0)
    return {};
  // Coordinates are taken from the centre, so that squares keep their digits.
  const glm::dvec3 centre = mesh.bounds().centre();
  const CutSurface cut = cutOpen(mesh.vertexCount(), mesh.triangles());
  CollapseMesh open = collapseMesh(mesh, cut, centre);
  std::vector<float> cutTolerances;
  cutTolerances.reserve(cut.originals.size());
  for (const std::uint32_t original : cut.originals)
    cutTolerances.push_back(tolerances[original]);

  EdgeDecimater decimater(open);
  QuadricModule::Handle quadrics;
  ShapeModule::Handle shape;
  SeamModule::Handle seams;
  decimater.add(seams);
  decimater.add(shape);
  decimater.add(quadrics);
  decimater.module(quadrics).setTolerances(std::move(cutTolerances));
  decimater.module(shape).setPlaces(decimater.module(quadrics));
  decimater.module(seams).setCut(cut);
  decimater.initialize();
  return decimater.decimate(decimater.module(quadrics), cut, goesOn)
             ? sewn(open, cut, centre, mesh.vertexCount())
             : Collapsed();
}

}  // namespace sline::model
