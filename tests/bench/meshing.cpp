// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/meshing.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <span>

#include "model/fairing/half_edges.h"
#include "model/fairing/vertex_rings.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/spatial_order.h"
#include "model/meshing/edge_collapse.h"
#include "model/meshing/loop_subdivision.h"
#include "model/meshing/simplification.h"

namespace sline::bench {

namespace {
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<>;

double processorMs(const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, 1e3 * double(std::clock() - begin) / double(CLOCKS_PER_SEC));
  }
  return least;
}

std::size_t largestValence(std::size_t vertexCount, std::span<const model::Triangle> triangles) {
  const model::HalfEdges edges(vertexCount, triangles);
  const model::VertexRings rings(vertexCount, triangles, edges);
  std::size_t most = 0;
  for (std::size_t v = 0; v < vertexCount; ++v)
    most = std::max(most, rings[v].size());
  return most;
}

/// Adds all faces and returns how many OpenMesh refused.
std::size_t addAll(OpenMeshMesh& to, const model::Mesh& mesh) {
  to.reserve(mesh.vertexCount(), mesh.triangleCount() * 3 / 2, mesh.triangleCount());
  for (const glm::vec3& p : mesh.positions())
    to.add_vertex({p.x, p.y, p.z});
  using Vertex = OpenMeshMesh::VertexHandle;
  for (const auto& [a, b, c] : mesh.triangles())
    to.add_face(Vertex(int(a)), Vertex(int(b)), Vertex(int(c)));
  return mesh.triangleCount() - to.n_faces();
}

model::MeshPtr meshOf(OpenMeshMesh& from) {
  from.garbage_collection();
  std::vector<glm::vec3> positions;
  for (const auto v : from.vertices())
    positions.emplace_back(from.point(v)[0], from.point(v)[1], from.point(v)[2]);
  std::vector<model::Triangle> triangles;
  for (const auto f : from.faces()) {
    model::Triangle t{};
    std::transform(from.cfv_begin(f), from.cfv_end(f), t.begin(),
                   [](const auto& v) { return std::uint32_t(v.idx()); });
    triangles.push_back(t);
  }
  return std::make_shared<const model::Mesh>(
      model::Mesh::create(std::move(positions), std::move(triangles)).value());
}

/// Returns the mesh that DecimaterT leaves below that quadric error, with a limit of 75° on normals
/// and of ten on aspects, as in our own.
model::MeshPtr decimatedBelow(const model::Mesh& mesh, double quadricError) {
  namespace Decimater = OpenMesh::Decimater;
  OpenMeshMesh work;
  addAll(work, mesh);
  work.request_face_normals();
  work.update_face_normals();
  // These are kept beyond the decimater, since they say which faces are deleted.
  work.request_vertex_status();
  work.request_edge_status();
  work.request_face_status();
  {
    Decimater::DecimaterT<OpenMeshMesh> decimater(work);
    Decimater::ModQuadricT<OpenMeshMesh>::Handle quadric;
    Decimater::ModNormalFlippingT<OpenMeshMesh>::Handle flips;
    Decimater::ModAspectRatioT<OpenMeshMesh>::Handle aspects;
    decimater.add(quadric);
    decimater.add(flips);
    decimater.add(aspects);
    decimater.module(quadric).set_max_err(quadricError, false);
    decimater.module(flips).set_max_normal_deviation(75.0);
    decimater.module(aspects).set_aspect_ratio(10.0f);
    decimater.initialize();
    decimater.decimate();
  }
  return meshOf(work);
}

float apart(const model::MeshPtr& a, const model::MeshPtr& b, float spacing) {
  using model::Bvh;
  using model::farthestSample;
  return std::max(farthestSample(*a, Bvh(b, model::spatialOrder(*b)), spacing),
                  farthestSample(*b, Bvh(a, model::spatialOrder(*a)), spacing));
}

/// Returns the fewest triangles within the bound that any of many quadric errors leaves (the true
/// error does not grow with them steadily); the time is that of the one run that leads there.
Decimated openMeshWithin(const model::MeshPtr& mesh, float bound) {
  const float spacing = model::meanEdgeLength(mesh->positions(), mesh->triangles());
  Decimated best{.triangles = mesh->triangleCount()};
  double bestError = 0.0;
  for (double exponent = -3.0; exponent <= 3.0; exponent += 0.25) {
    const double quadricError = std::pow(double(bound), 4.0) * std::pow(10.0, exponent);
    const model::MeshPtr fewer = decimatedBelow(*mesh, quadricError);
    const float error = apart(mesh, fewer, spacing);
    if (error <= bound && fewer->triangleCount() < best.triangles) {
      best = {.triangles = fewer->triangleCount(), .error = error};
      bestError = quadricError;
    }
  }
  best.milliseconds = processorMs([&] { decimatedBelow(*mesh, bestError); });
  return best;
}

Decimated oursWithin(const model::MeshPtr& mesh, float bound) {
  const auto always = [] { return true; };
  const model::Simplified fewer = model::simplified(mesh, bound, always);
  const std::vector<float> tolerances(mesh->vertexCount(), 0.5f * bound);
  return {
      .triangles = fewer.mesh->triangleCount(),
      .error = fewer.error,
      .milliseconds = processorMs([&] { model::withEdgesCollapsed(*mesh, tolerances, always); })};
}
}  // namespace

MeshingRow measureMeshing(const std::string& name, const model::MeshPtr& mesh, float bound) {
  omerr().disable();
  MeshingRow row{.name = name, .triangles = mesh->triangleCount()};
  row.decimated = oursWithin(mesh, bound);
  row.openMeshDecimated = openMeshWithin(mesh, bound);
  const std::vector<glm::vec3> positions(mesh->positions().begin(), mesh->positions().end());
  const std::vector<model::Triangle> triangles(mesh->triangles().begin(), mesh->triangles().end());
  row.adjacencyMs = processorMs([&] {
    const model::HalfEdges edges(positions.size(), triangles);
    const model::VertexRings rings(positions.size(), triangles, edges);
  });
  row.openMeshAdjacencyMs = processorMs([&] {
    OpenMeshMesh work;
    row.refusedFaces = addAll(work, *mesh);
  });
  // Otherwise LoopT's table of weights ends at a valence of 50, and it would read on beyond.
  const std::size_t mostNeighbours = largestValence(positions.size(), triangles);
  row.subdivisionMs = processorMs([&] { model::loopSubdivided(positions, triangles); });
  row.openMeshSubdivisionMs = processorMs([&] {
    OpenMeshMesh work;
    addAll(work, *mesh);
    OpenMesh::Subdivider::Uniform::LoopT<OpenMeshMesh, float> loop;
    loop.init_weights(mostNeighbours + 1);
    loop.attach(work);
    loop(1);
    loop.detach();
  });
  return row;
}

std::string asText(const std::vector<MeshingRow>& rows) {
  std::string text =
      "ours | OpenMesh's own, ms of the processor\n"
      "triangles   decimated to (mm, ms)                        adjacency     Loop         "
      "refused\n";
  for (const MeshingRow& row : rows) {
    std::array<char, 200> line{};
    std::snprintf(line.data(), line.size(),
                  "%8zu %8zu (%.2f,%6.0f) |%8zu (%.2f,%6.0f) %6.1f |%6.1f %6.1f |%6.1f %6zu  ",
                  row.triangles, row.decimated.triangles, double(row.decimated.error),
                  row.decimated.milliseconds, row.openMeshDecimated.triangles,
                  double(row.openMeshDecimated.error), row.openMeshDecimated.milliseconds,
                  row.adjacencyMs, row.openMeshAdjacencyMs, row.subdivisionMs,
                  row.openMeshSubdivisionMs, row.refusedFaces);
    text += line.data() + row.name + '\n';
  }
  return text;
}

}  // namespace sline::bench
