// SPDX-License-Identifier: Apache-2.0
#include "render/lines/lines.h"

#include <algorithm>
#include <glm/vector_relational.hpp>

#include "model/base/parallel.h"
#include "render/lines/line_technique.h"

namespace sline::render {

using model::Cluster;
using model::Facing;
using model::Surface;

namespace {

constexpr std::size_t clustersPerTask = 48;

void extract(ClusterWalk& walk, const Cluster& cluster, const LineRequest& request,
             LineSet& lines) {
  const Facing facing = model::facing(cluster, walk.eye());
  if (facing == Facing::back && !request.twoSided)
    return;
  bool entered = false;
  for (const LineTechnique& technique : lineTechniques()) {
    if (!technique.mayPass || !request.kinds.has(technique.kind) ||
        !technique.mayPass(cluster, facing))
      continue;
    if (!entered)
      walk.enter(cluster);
    entered = true;
    technique.extract(walk, request, lines[technique.kind]);
  }
}

/// Finds the lines of a technique that looks at the whole surface.
void find(const LineTechnique& technique, const Surface& surface, const model::Camera& camera,
          const LineRequest& request, std::vector<Segment>& segments) {
  LinePreparations own;
  LinePreparations& kept = request.preparations ? *request.preparations : own;
  const std::shared_ptr<const PreparedLines> prepared =
      technique.prepare ? kept.of(technique.kind, surface) : nullptr;
  technique.find({surface, camera, request, prepared.get()}, segments);
}

}  // namespace

LineThresholds::LineThresholds() {
  for (const LineTechnique& technique : lineTechniques())
    for (std::size_t i = 0; i < technique.thresholds.size(); ++i)
      set(technique.kind, i, technique.thresholds[i].usual);
}

LineSet extractLines(const Surface& surface, const model::Camera& camera,
                     const LineRequest& request) {
  const model::EyePoint eye = eyeOf(camera);
  const std::vector<Cluster>& clusters = surface.clusters.items;
  std::vector<LineSet> parts((clusters.size() + clustersPerTask - 1) / clustersPerTask);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    ClusterWalk walk(surface, eye);
    const std::size_t end = std::min(clusters.size(), (part + 1) * clustersPerTask);
    for (std::size_t i = part * clustersPerTask; i < end; ++i)
      extract(walk, clusters[i], request, parts[part]);
  });
  LineSet lines;
  for (const LineTechnique& technique : lineTechniques()) {
    std::vector<Segment>& all = lines[technique.kind];
    if (technique.find && request.kinds.has(technique.kind))
      find(technique, surface, camera, request, all);
    std::size_t count = 0;
    for (const LineSet& part : parts)
      count += part[technique.kind].size();
    all.reserve(all.size() + count);
    for (const LineSet& part : parts)
      all.insert(all.end(), part[technique.kind].begin(), part[technique.kind].end());
  }
  return lines;
}

bool needsTwoSides(const Surface& surface, const model::Camera& camera) {
  if (!surface.closed)
    return true;
  if (camera.projection == model::Projection::orthographic)
    return false;
  const model::Box& box = surface.mesh->bounds();
  return glm::all(glm::greaterThanEqual(camera.eye, box.low)) &&
         glm::all(glm::lessThanEqual(camera.eye, box.high));
}

}  // namespace sline::render
