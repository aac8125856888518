// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <thread>
#include <vector>

#include "model/base/parallel.h"
#include "model/geometry/bvh.h"
#include "model/geometry/nearest_point.h"
#include "model/geometry/spatial_order.h"
#include "model/meshing/simplification.h"
#include "render/export/students/page_order.h"

namespace sline::render {

namespace {

/// Of the time that a page takes.
constexpr double simplifyingShare = 0.1;

using Replacements = std::map<model::MeshPtr, model::Simplified>;

/// Tells how far the work is, and whether it goes on; workers ask, the thread that began it tells.
class Work {
 public:
  explicit Work(const ExportProgress& progress) : m_progress(progress) {}

  void setShare(double share) { m_share = share; }
  bool goesOn() {
    if (m_progress && std::this_thread::get_id() == m_thread)
      m_on = m_on && m_progress(simplifyingShare * m_share, "simplifying surfaces");
    return m_on;
  }

 private:
  const ExportProgress& m_progress;
  const std::thread::id m_thread = std::this_thread::get_id();
  std::atomic<double> m_share = 0.0;
  std::atomic<bool> m_on = true;
};

/// Makes of each mesh another one, the largest first, at the same time; `share` of all work is done
/// before, `part` are these.
template <class Make>
Replacements replaced(const model::Scene& scene, Work& work, double share, double part,
                      const Make& make) {
  const std::set<model::MeshPtr> all = model::meshesOf(scene);
  std::vector<model::MeshPtr> meshes(all.begin(), all.end());
  std::stable_sort(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) {
    return a->triangleCount() > b->triangleCount();
  });
  std::vector<model::Simplified> made(meshes.size());
  std::atomic<std::size_t> done = 0;
  parallelFor(meshes.size(), 1, [&](std::size_t i) {
    made[i] = work.goesOn() ? make(meshes[i]) : model::Simplified{meshes[i], 0.0f};
    work.setShare(share + part * double(++done) / double(meshes.size()));
  });
  Replacements fewer;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    fewer[meshes[i]] = std::move(made[i]);
  return fewer;
}

/// Makes every mesh as simple as the bound allows.
Replacements withinBound(const model::Scene& scene, float bound, Work& work) {
  return replaced(scene, work, 0.0, 1.0, [&](const model::MeshPtr& mesh) {
    return model::simplified(mesh, bound, [&work] { return work.goesOn(); });
  });
}

std::size_t trianglesOf(const Replacements& fewer) {
  std::size_t triangles = 0;
  for (const auto& [mesh, simple] : fewer)
    triangles += simple.mesh->triangleCount();
  return triangles;
}

/// Finds a tolerance that leaves no more triangles than wanted, within a tenth of the smallest
/// such. How far surfaces are off is measured in the end, as that takes longer than the rest.
Replacements withTriangles(const model::Scene& scene, std::size_t most, Work& work) {
  constexpr float smallest = 0.0005f;  // mm
  constexpr float largest = 20.0f;
  constexpr int turns = 7;
  constexpr double measuring = 0.3;  // of the time
  const model::Box box = scene.visibleBounds();
  float low = smallest;
  float high = largest;
  float tolerance =
      box.empty() ? smallest : std::clamp(0.0005f * glm::length(box.size()), smallest, largest);
  const auto collapsed = [&](int turn) {
    const double part = (1.0 - measuring) / double(turns + 1);
    return replaced(scene, work, part * turn, part, [&](const model::MeshPtr& mesh) {
      return model::Simplified{model::collapsed(mesh, tolerance, [&work] { return work.goesOn(); }),
                               0.0f};
    });
  };
  Replacements found = collapsed(0);
  Replacements best = found;
  for (int turn = 1; turn <= turns && work.goesOn(); ++turn) {
    const bool enough = trianglesOf(found) <= most;
    if (enough && (trianglesOf(best) > most || trianglesOf(best) < trianglesOf(found)))
      best = found;
    (enough ? high : low) = tolerance;
    if (high < 1.1f * low || (enough && 6 * trianglesOf(found) >= 5 * most))
      break;
    // Numbers of triangles go about as the tolerance to the power of -0.6.
    const float guess =
        tolerance * std::pow(float(trianglesOf(found)) / (0.93f * float(most)), 1.0f / 0.6f);
    tolerance = guess > 1.02f * low && guess < 0.98f * high ? guess : std::sqrt(low * high);
    found = collapsed(turn);
  }
  const Replacements& wanted = trianglesOf(best) <= most ? best : found;
  return replaced(scene, work, 1.0 - measuring, measuring, [&](const model::MeshPtr& mesh) {
    const model::MeshPtr& fewer = wanted.at(mesh).mesh;
    return model::Simplified{fewer, model::deviation(fewer, mesh)};
  });
}

/// Moves places on surfaces to where the new surfaces are nearest.
void moveAnnotations(model::Scene& scene, const model::Scene& before) {
  std::vector<model::Annotation> annotations = before.annotations();
  for (model::Annotation& annotation : annotations)
    for (model::Anchor& anchor : annotation.anchors) {
      auto* point = std::get_if<model::SurfacePoint>(&anchor);
      if (!point || scene.find(point->structure)->mesh == before.find(point->structure)->mesh)
        continue;
      const auto nearest =
          model::nearestPoint(*scene.find(point->structure)->mesh, *before.placeOf(anchor));
      if (nearest)
        anchor = model::SurfacePoint{point->structure, nearest->triangle, nearest->weights};
    }
  scene.setAnnotations(std::move(annotations));
}

/// Paints each vertex as the nearest corner of the triangle that it lies on.
model::PaintPtr movedPaint(const model::Paint& paint, const model::MeshPtr& from,
                           const model::Mesh& to) {
  const model::Bvh surface(from, model::spatialOrder(*from));
  model::Paint moved(to.positions().size());
  parallelFor(moved.size(), 256, [&](std::size_t i) {
    const glm::vec3 place = to.positions()[i];
    const model::Triangle& corners = from->triangles()[surface.closest(place).triangle];
    moved[i] = paint[*std::min_element(corners.begin(), corners.end(),
                                       [&](std::uint32_t a, std::uint32_t b) {
                                         return glm::distance(from->positions()[a], place) <
                                                glm::distance(from->positions()[b], place);
                                       })];
  });
  return std::make_shared<const model::Paint>(std::move(moved));
}

}  // namespace

SimplifiedScene simplifiedScene(const model::Scene& scene, const StudentsOptions& own,
                                const ExportProgress& progress) {
  const auto most = std::size_t(own.triangles);
  const bool tooMany = most > 0 && trianglesOf(scene) > most;
  if (!tooMany && own.errorMm <= 0.0)
    return {scene, 0.0f};
  Work work(progress);
  Replacements fewer;
  if (own.errorMm > 0.0)
    fewer = withinBound(scene, float(own.errorMm), work);
  if (tooMany && (fewer.empty() || trianglesOf(fewer) > most))
    fewer = withTriangles(scene, most, work);
  SimplifiedScene simple{scene, 0.0f};
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes) {
    const auto found = node.mesh ? fewer.find(node.mesh) : fewer.end();
    if (found == fewer.end() || found->second.mesh == node.mesh)
      continue;
    simple.errorMm = std::max(simple.errorMm, found->second.error);
    if (node.paint)
      node.paint = movedPaint(*node.paint, node.mesh, *found->second.mesh);
    node.provenance.decimatedFrom =
        std::max(node.provenance.decimatedFrom, int(node.mesh->triangleCount()));
    node.provenance.decimationMm += found->second.error;
    node.mesh = found->second.mesh;
  }
  simple.scene.setAnnotations({});
  simple.scene.setNodes(std::move(nodes));
  moveAnnotations(simple.scene, scene);
  return simple;
}

}  // namespace sline::render
