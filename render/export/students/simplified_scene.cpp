// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "model/geometry/nearest_point.h"
#include "model/meshing/simplification.h"
#include "render/export/students/page_order.h"

namespace sline::render {

namespace {

using Replacements = std::map<model::MeshPtr, model::Simplified>;

/// Makes every mesh as simple as the bound allows; stops where it is no longer wanted.
Replacements simplifiedMeshes(const model::Scene& scene, float bound,
                              const std::function<bool()>& goesOn) {
  Replacements fewer;
  for (const model::MeshPtr& mesh : model::meshesOf(scene))
    if (goesOn())
      fewer[mesh] = model::simplified(mesh, bound, goesOn);
  return fewer;
}

std::size_t trianglesOf(const Replacements& fewer) {
  std::size_t triangles = 0;
  for (const auto& [mesh, simple] : fewer)
    triangles += simple.mesh->triangleCount();
  return triangles;
}

/// Finds a bound that leaves no more triangles than wanted, within a tenth of the smallest such.
Replacements withTriangles(const model::Scene& scene, std::size_t most,
                           const std::function<bool()>& goesOn) {
  constexpr float smallest = 0.0005f;  // mm
  constexpr float largest = 20.0f;
  const model::Box box = scene.visibleBounds();
  float low = smallest;
  float bound =
      box.empty() ? smallest : std::clamp(0.0005f * glm::length(box.size()), smallest, largest);
  float high = largest;
  Replacements found = simplifiedMeshes(scene, bound, goesOn);
  Replacements best = found;
  for (int turn = 0; turn < 7 && goesOn(); ++turn) {
    const bool enough = trianglesOf(found) <= most;
    if (enough && (trianglesOf(best) > most || trianglesOf(best) < trianglesOf(found)))
      best = found;
    (enough ? high : low) = bound;
    if (high < 1.1f * low || (enough && 6 * trianglesOf(found) >= 5 * most))
      break;
    // Numbers of triangles go about as the bound to the power of -0.6.
    const float guess =
        bound * std::pow(float(trianglesOf(found)) / (0.93f * float(most)), 1.0f / 0.6f);
    bound = guess > 1.02f * low && guess < 0.98f * high ? guess : std::sqrt(low * high);
    found = simplifiedMeshes(scene, bound, goesOn);
  }
  return trianglesOf(best) <= most ? best : found;
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

model::PaintPtr movedPaint(const model::Paint& paint, const model::Mesh& from,
                           const model::Mesh& to) {
  model::Paint moved;
  moved.reserve(to.positions().size());
  for (const glm::vec3& place : to.positions()) {
    const auto nearest = model::nearestPoint(from, place);
    const model::Triangle& corners = from.triangles()[nearest->triangle];
    const std::size_t corner = nearest->weights[0] > 0.5f ? 1 : nearest->weights[1] > 0.5f ? 2 : 0;
    moved.push_back(paint[corners[corner]]);
  }
  return std::make_shared<const model::Paint>(std::move(moved));
}

}  // namespace

SimplifiedScene simplifiedScene(const model::Scene& scene, const StudentsOptions& own,
                                const ExportProgress& progress) {
  const auto most = std::size_t(own.triangles);
  const bool tooMany = most > 0 && trianglesOf(scene) > most;
  if (!tooMany && own.errorMm <= 0.0)
    return {scene, 0.0f};
  const auto goesOn = [&progress] { return !progress || progress(0.05, "simplifying surfaces"); };
  Replacements fewer;
  if (own.errorMm > 0.0)
    fewer = simplifiedMeshes(scene, float(own.errorMm), goesOn);
  if (tooMany && (fewer.empty() || trianglesOf(fewer) > most))
    fewer = withTriangles(scene, most, goesOn);
  SimplifiedScene simple{scene, 0.0f};
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes) {
    const auto found = node.mesh ? fewer.find(node.mesh) : fewer.end();
    if (found == fewer.end() || found->second.mesh == node.mesh)
      continue;
    simple.errorMm = std::max(simple.errorMm, found->second.error);
    if (node.paint)
      node.paint = movedPaint(*node.paint, *node.mesh, *found->second.mesh);
    node.mesh = found->second.mesh;
  }
  simple.scene.setAnnotations({});
  simple.scene.setNodes(std::move(nodes));
  moveAnnotations(simple.scene, scene);
  return simple;
}

}  // namespace sline::render
