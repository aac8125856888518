// SPDX-License-Identifier: Apache-2.0
#include "render/lines/lines.h"

#include <algorithm>
#include <glm/vector_relational.hpp>
#include <span>

#include "model/base/parallel.h"
#include "render/lines/line_technique.h"

namespace sline::render {

using model::Cluster;
using model::Facing;
using model::Surface;

namespace {

constexpr std::size_t clustersPerTask = 128;

/// Returns those of the wanted techniques whose lines come from clusters.
std::vector<const LineTechnique*> byCluster(const LineRequest& request) {
  std::vector<const LineTechnique*> techniques;
  for (const LineTechnique& technique : lineTechniques())
    if (technique.mayPass && request.kinds.has(technique.kind))
      techniques.push_back(&technique);
  return techniques;
}

/// A cluster, and how it faces the eye.
struct Faced {
  const Cluster& cluster;
  Facing facing;
};

void extract(ClusterWalk& walk, const Faced& faced, const LineRequest& request,
             std::span<const LineTechnique* const> techniques, LineSet& lines) {
  const auto& [cluster, facing] = faced;
  if (facing == Facing::back && !request.twoSided)
    return;
  bool entered = false;
  for (const LineTechnique* technique : techniques) {
    if (!technique->mayPass(cluster, facing, walk.eye()))
      continue;
    if (!entered)
      walk.enter(cluster);
    entered = true;
    technique->extract(walk, request, lines[technique->kind]);
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
  const std::vector<const LineTechnique*> techniques = byCluster(request);
  std::vector<LineSet> parts(
      techniques.empty() ? 0 : (clusters.size() + clustersPerTask - 1) / clustersPerTask);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    ClusterWalk walk(surface, eye);
    const std::size_t first = part * clustersPerTask;
    const std::size_t end = std::min(clusters.size(), first + clustersPerTask);
    Facing next = model::facing(clusters[first], eye);
    for (std::size_t i = first; i < end; ++i) {
      const Facing facing = next;
      if (i + 1 < end) {
        next = model::facing(clusters[i + 1], eye);
        if (next == Facing::mixed)
          walk.fetch(clusters[i + 1]);
      }
      extract(walk, {clusters[i], facing}, request, techniques, parts[part]);
    }
  });
  LineSet lines;
  parallelFor(techniques.size(), 1, [&](std::size_t i) {
    const LineKind kind = techniques[i]->kind;
    std::vector<Segment>& all = lines[kind];
    std::size_t count = 0;
    for (const LineSet& part : parts)
      count += part[kind].size();
    all.reserve(count);
    for (const LineSet& part : parts)
      all.insert(all.end(), part[kind].begin(), part[kind].end());
  });
  for (const LineTechnique& technique : lineTechniques())
    if (technique.find && request.kinds.has(technique.kind))
      find(technique, surface, camera, request, lines[technique.kind]);
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
