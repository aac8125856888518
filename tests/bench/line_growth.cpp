// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/line_growth.h"

#include <malloc.h>

#include <cmath>
#include <iomanip>
#include <ostream>

#include "model/geometry/surface.h"
#include "render/gpu/headless/context.h"
#include "render/lines/techniques/line_technique.h"
#include "tests/bench/measure.h"
#include "tests/bench/stage.h"
#include "tests/bench/vtk_phong.h"
#include "tests/support/process_memory.h"

namespace sline::bench {

namespace {

struct GrowthCost {
  std::size_t triangles = 0;
  double prepareMs = 0.0;
  double bytes = 0.0;  ///< kept by preparation
  std::size_t segments = 0;
  Spread lines;
  Spread silhouette;
  Spread phong;
};

/// Calls `body` for each camera, after one call to warm up.
template <class Body>
Spread timesOf(std::span<const model::Camera> cameras, const Body& body) {
  body(cameras.back());
  std::vector<double> times;
  for (const model::Camera& camera : cameras) {
    const Stopwatch watch;
    body(camera);
    times.push_back(watch.milliseconds());
  }
  return spreadOf(times);
}

Spread linesOf(const LineGrowthRun& run, const std::vector<model::SurfacePtr>& surfaces,
               GrowthCost& cost) {
  return timesOf(run.cameras, [&](const model::Camera& camera) {
    cost.segments = 0;
    for (const model::SurfacePtr& surface : surfaces) {
      const bool twoSided = render::needsTwoSides(*surface, camera);
      const render::LineSet lines =
          render::extractLines(*surface, camera,
                               {.thresholds = render::thresholdsAt(Gamma::clamped(2.0f)),
                                .twoSided = twoSided,
                                .hiddenContours = twoSided});
      cost.segments +=
          lines[render::LineKind::contour].size() + lines[render::LineKind::suggestive].size();
    }
  });
}

Result<GrowthCost> growthCostOf(const LineGrowthRun& run, const model::Scene& scene) {
  GrowthCost cost;
  std::vector<model::MeshPtr> meshes;
  for (const model::NodeId id : scene.structuresBelow(model::rootId))
    meshes.push_back(scene.find(id)->mesh);
  // Memory that was freed before must not count as free afterwards.
  malloc_trim(0);
  const double before = test::residentMiB();
  const Stopwatch watch;
  std::vector<model::SurfacePtr> surfaces;
  for (const model::MeshPtr& mesh : meshes) {
    cost.triangles += mesh->triangleCount();
    surfaces.push_back(model::prepareSurface(mesh));
  }
  cost.prepareMs = watch.milliseconds();
  malloc_trim(0);
  cost.bytes = (test::residentMiB() - before) * 1024.0 * 1024.0;
  cost.lines = linesOf(run, surfaces, cost);
  surfaces.clear();
  std::vector<VtkSilhouette> silhouettes(meshes.begin(), meshes.end());
  cost.silhouette = timesOf(run.cameras, [&](const model::Camera& camera) {
    for (VtkSilhouette& silhouette : silhouettes)
      silhouette.update(camera);
  });
  silhouettes.clear();
  auto context = render::gpu::HeadlessContext::create();
  if (!context)
    return context.error();
  VtkPhong phong(scene, run.size.x, run.size.y);
  cost.phong = timesOf(run.cameras, [&](const model::Camera& camera) { phong.draw(camera); });
  return cost;
}

double exponent(const GrowthCost& first, const GrowthCost& last, Spread GrowthCost::*time) {
  return std::log((last.*time).median / (first.*time).median) /
         std::log(double(last.triangles) / double(first.triangles));
}

}  // namespace

Status measureLineGrowth(const LineGrowthRun& run, std::ostream& out) {
  out << std::fixed
      << " triangles  prepared ms per M  bytes/tri.  segments    lines ms (95 %)  silhouette ms  "
         "Phong ms  lines / Phong  silhouette / lines\n";
  std::vector<GrowthCost> costs;
  model::Scene scene = run.scene;
  for (int level = 0; level <= run.subdivisions; ++level) {
    if (level > 0)
      scene = subdivided(scene);
    const Result<GrowthCost> cost = growthCostOf(run, scene);
    if (!cost)
      return cost.error();
    const double millions = double(cost->triangles) / 1e6;
    out << std::setw(10) << cost->triangles << std::setprecision(0) << std::setw(12)
        << cost->prepareMs << std::setw(7) << cost->prepareMs / millions << std::setprecision(1)
        << std::setw(12) << cost->bytes / double(cost->triangles) << std::setw(10) << cost->segments
        << std::setprecision(2) << std::setw(12) << cost->lines.median << " (" << cost->lines.p95
        << ")" << std::setw(15) << cost->silhouette.median << std::setw(10) << cost->phong.median
        << std::setprecision(3) << std::setw(15) << cost->lines.median / cost->phong.median
        << std::setprecision(1) << std::setw(20) << cost->silhouette.median / cost->lines.median
        << std::endl;
    costs.push_back(*cost);
  }
  if (costs.size() > 1)
    out << std::setprecision(2) << "grow by the power of: lines "
        << exponent(costs.front(), costs.back(), &GrowthCost::lines) << ", silhouette "
        << exponent(costs.front(), costs.back(), &GrowthCost::silhouette) << ", Phong "
        << exponent(costs.front(), costs.back(), &GrowthCost::phong) << '\n';
  return Unit{};
}

}  // namespace sline::bench
