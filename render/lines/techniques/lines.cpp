// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vector_relational.hpp>
#include <span>

#include "model/base/parallel.h"
#include "render/lines/techniques/line_technique.h"

namespace sline::render {

using model::Cluster;
using model::Facing;
using model::Surface;

namespace {

constexpr std::size_t groupsPerTask = 2;

/// Returns those of the wanted techniques whose lines come from clusters.
std::vector<const LineTechnique*> byCluster(const LineRequest& request) {
  std::vector<const LineTechnique*> techniques;
  for (const LineTechnique& technique : lineTechniques())
    if (technique.mayPass && request.kinds.has(technique.kind))
      techniques.push_back(&technique);
  return techniques;
}

/// Finds lines by cluster, one group of clusters after the other.
class GroupScan {
 public:
  GroupScan(const Surface& surface, const model::EyePoint& eye, const LineRequest& request,
            std::span<const LineTechnique* const> techniques)
      : m_clusters(surface.clusters),
        m_request(request),
        m_techniques(techniques),
        m_walk(surface, eye) {}

  void scan(std::size_t group, LineSet& lines) {
    const Mask all = (Mask(1) << m_techniques.size()) - 1;
    const Mask some = passing(m_clusters.groups[group], all);
    if (some == 0)
      return;
    const std::size_t first = group * model::Clusters::itemsOfGroup;
    const std::size_t end =
        std::min(m_clusters.items.size(), first + model::Clusters::itemsOfGroup);
    m_found.clear();
    for (std::size_t i = first; i < end; ++i)
      if (const Mask own = passing(m_clusters.items[i], some); own != 0)
        m_found.push_back({&m_clusters.items[i], own});
    for (std::size_t i = 0; i < m_found.size(); ++i) {
      if (i + 1 < m_found.size())
        fetch(*m_found[i + 1].cluster);
      extract(*m_found[i].cluster, m_found[i].techniques, lines);
    }
  }

 private:
  using Mask = std::uint32_t;  ///< a bit for each technique
  static_assert(lineKindCount < 32);

  /// Returns those of the techniques whose lines may pass through a cluster or group.
  Mask passing(const Cluster& cluster, Mask techniques) const {
    const Facing facing = model::facing(cluster, m_walk.eye());
    if (facing == Facing::back && !m_request.twoSided)
      return 0;
    Mask passing = 0;
    for (std::size_t i = 0; i < m_techniques.size(); ++i)
      if ((techniques >> i & 1u) != 0 && m_techniques[i]->mayPass(cluster, facing, m_walk.eye()))
        passing |= Mask(1) << i;
    return passing;
  }

  /// Has the processor fetch what techniques look at first.
  void fetch(const Cluster& cluster) const {
    constexpr std::size_t line = 64;  // bytes of the processor's cache
    const auto all = [](const void* from, std::size_t bytes) {
      for (std::size_t at = 0; at < bytes; at += line)
        __builtin_prefetch(static_cast<const char*>(from) + at);
    };
    all(m_clusters.samples.data() + cluster.firstSample,
        model::Clusters::placeRows * cluster.vertexCount +
            model::Clusters::bendingRows * cluster.candidateVertices);
    all(m_clusters.localTriangles.data() + cluster.firstTriangle,
        std::size_t(3) * cluster.triangleCount);
    all(m_clusters.vertices.data() + cluster.firstVertex, std::size_t(4) * cluster.vertexCount);
  }

  void extract(const Cluster& cluster, Mask techniques, LineSet& lines) {
    m_walk.enter(cluster);
    for (std::size_t i = 0; i < m_techniques.size(); ++i)
      if ((techniques >> i & 1u) != 0)
        m_techniques[i]->extract(m_walk, m_request, lines[m_techniques[i]->kind]);
  }

  const model::Clusters& m_clusters;
  const LineRequest& m_request;
  std::span<const LineTechnique* const> m_techniques;
  ClusterWalk m_walk;
  struct Found {
    const Cluster* cluster;
    Mask techniques;
  };
  std::vector<Found> m_found;  ///< in the group in work
};

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
  const std::vector<const LineTechnique*> techniques = byCluster(request);
  const std::size_t groups = techniques.empty() ? 0 : surface.clusters.groups.size();
  std::vector<LineSet> parts(groups);
  parallelChunks(groups, groupsPerTask, [&](std::size_t begin, std::size_t end) {
    GroupScan scan(surface, eye, request, techniques);
    for (std::size_t group = begin; group < end; ++group)
      scan.scan(group, parts[begin]);
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
