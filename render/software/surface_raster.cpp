// SPDX-License-Identifier: Apache-2.0
#include "render/software/surface_raster.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "model/base/parallel.h"
#include "render/lines/ground/view_fields.h"
#include "render/software/cluster_cuts.h"
#include "render/software/placed_clusters.h"
#include "render/software/surface_values.h"

namespace sline::render {

namespace {

/// Where bands of rows put what they draw.
struct BandOutput {
  std::span<float> depths;
  std::span<std::uint32_t> colours;
  SurfaceValues* kept = nullptr;  ///< null: the values are forgotten once they are shaded
};

/// Draws rows of samples. Bands of rows can be drawn at the same time.
class SurfaceBand {
 public:
  SurfaceBand(std::span<const ReadyMember> members, const RasterSight& sight,
              const BandOutput& output)
      : m_members(members),
        m_view(sight.view),
        m_samples(sight.samples),
        m_rectangles(sight.rectangles),
        m_depths(output.depths.data()),
        m_colours(output.colours.empty() ? nullptr : output.colours.data()),
        m_kept(output.kept) {
    for (const ReadyMember& member : members)
      for (std::size_t value = 0; value < sampleValueCount; ++value)
        m_needs[value] = m_needs[value] || member.shading.needed()[value];
  }

  void setRows(int first, int end) {
    m_first = first;
    m_end = end;
    const auto width = std::size_t(m_samples.area.width);
    const std::size_t samples = std::size_t(end - first) * width;
    for (std::size_t value = 0; value < sampleValueCount; ++value) {
      if (!m_needs[value])
        continue;
      if (!m_kept)
        m_own[value].resize(samples);
      m_values[value] =
          m_kept ? m_kept->values[value].data() + std::size_t(first) * width : m_own[value].data();
    }
    if (m_colours && m_members.size() > 1)
      m_owners.resize(samples);
  }

  /// Has the memory fetch what will be looked at soon.
  void fetch(const PlacedCluster& placed) const {
    const ReadyMember& member = m_members[placed.member];
    const model::Surface& surface = member.shown->surface();
    const model::Clusters& clusters = *member.clusters;
    const model::Cluster& cluster = *placed.cluster;
    const std::uint32_t* vertices = clusters.vertices.data() + cluster.firstVertex;
    const bool shaded = isShaded(member);
    const auto fetchVertices = [&] {
      for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
        __builtin_prefetch(&surface.vertices[vertices[i]]);
    };
    __builtin_prefetch(clusters.localTriangles.data() + cluster.firstTriangle);
    if (const float* row = clusters.cornerRow(cluster, 0)) {
      constexpr std::size_t together = 16;  // in a line of a processor's cache
      for (std::size_t i = 0; i < model::Clusters::cornerRows * cluster.vertexCount; i += together)
        __builtin_prefetch(row + i);
      if (shaded && member.shading.fill().byForm)
        fetchVertices();
      return;
    }
    const glm::vec3* positions = surface.mesh->positions().data();
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
      __builtin_prefetch(positions + vertices[i]);
    if (shaded)
      fetchVertices();
  }

  /// Returns false where the cluster has to be clipped.
  bool add(const PlacedCluster& placed) {
    const ReadyMember& member = m_members[placed.member];
    const model::Cluster& cluster = *placed.cluster;
    const ClusterPlaces places{*member.clusters, member.shown->surface().mesh->positions()};
    m_member = placed.member;
    m_cuts.find(cluster, member.planes);
    if (m_samples.grid.step > 1 && m_cuts.empty() && splat(cluster, member))
      return true;
    if (!m_seen.project(cluster, places, m_view, m_samples.grid))
      return false;
    const auto* triangles = member.clusters->localTriangles.data() + cluster.firstTriangle;
    m_seen.findBoxes({triangles, cluster.triangleCount});
    const bool mixed = member.cull && model::facing(cluster, m_view.eye()) != model::Facing::front;
    const bool shaded = isShaded(member);
    if (!m_cuts.empty())
      m_cuts.measure(cluster, places);
    // Across little depth values are as good as linear in the picture.
    m_even = isEven(cluster);
    const std::span<const std::uint8_t> drawn = holders(cluster, mixed);
    if (drawn.empty())
      return true;
    m_seen.findSlopes(cluster.triangleCount, SeenCluster::Corners::exact);
    if (shaded)
      load(cluster, member);
    for (const std::uint8_t i : drawn) {
      if (!m_seen.withinDepths && !(m_seen.least[i] >= 0.0f && m_seen.most[i] <= 1.0f))
        return false;
      if (shaded)
        draw<true>(i, triangles[i]);
      else
        draw<false>(i, triangles[i]);
    }
    return true;
  }

  /// Finds the colours of all that was added.
  void shade() {
    if (!m_colours)
      return;
    for (const PixelRect& rect : m_rectangles)
      for (int row = std::max(rect.y, m_first); row < std::min(rect.top(), m_end); ++row)
        shade(row, rect.x, rect.right());
  }

 private:
  std::size_t bandIndex(int column, int row) const {
    return std::size_t(row - m_first) * std::size_t(m_samples.area.width) + std::size_t(column);
  }
  bool isShaded(const ReadyMember& member) const {
    return (m_colours || m_kept) && member.shading.shaded();
  }
  std::uint16_t ownerAt(int column, int row) const {
    return m_owners.empty() ? std::uint16_t(0) : m_owners[bandIndex(column, row)];
  }

  /// Lists those of the cluster's triangles that may hold the middle of one of the band's samples;
  /// of a mixed cluster those that turn to the eye.
  std::span<const std::uint8_t> holders(const model::Cluster& cluster, bool mixed) {
    const PixelRect& area = m_samples.area;
    const int left = area.x, right = area.right();
    const int bottom = area.y + m_first, top = area.y + m_end;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      m_holders[count] = std::uint8_t(i);
      const int columns =
          std::min(m_seen.left[i] + m_seen.columns[i], right) - std::max(m_seen.left[i], left);
      const int rows =
          std::min(m_seen.bottom[i] + m_seen.rows[i], top) - std::max(m_seen.bottom[i], bottom);
      const int turns = int(!mixed) | int(m_seen.area[i] > 0.0f);
      count += std::size_t(int(columns > 0) & int(rows > 0) & turns);
    }
    return {m_holders.data(), count};
  }

  void shade(int row, int first, int end) {
    const float* depths = m_depths + std::size_t(row) * std::size_t(m_samples.area.width);
    for (int column = first; column < end;) {
      if (!(depths[column] < 1.0f)) {
        ++column;
        continue;
      }
      const std::uint16_t owner = ownerAt(column, row);
      int next = column + 1;
      while (next < end && depths[next] < 1.0f && ownerAt(next, row) == owner)
        ++next;
      ValueSpans values{};
      for (std::size_t value = 0; value < sampleValueCount; ++value)
        values[value] = m_needs[value] ? m_values[value] + bandIndex(column, row) : nullptr;
      m_members[owner].shading.shade(
          m_view, m_samples, {row, column, next}, values,
          m_colours + std::size_t(row) * std::size_t(m_samples.area.width) + column);
      column = next;
    }
  }

  /// Draws a cluster that is hardly larger than a sample as a disc (Rusinkiewicz and Levoy 2000,
  /// QSplat). It lies behind the cluster, so that it hides none of the surface's own lines. Returns
  /// false, with nothing drawn, where the cluster is larger, reaches out of the view or lies at an
  /// outline, which a disc would reach beyond.
  bool splat(const model::Cluster& cluster, const ReadyMember& member) {
    constexpr float largest = 0.75f;  // radius, in samples
    if (model::facing(cluster, m_view.eye()) != model::Facing::front)
      return false;
    const model::Sphere& sphere = cluster.bounds;
    const float pixel = m_view.millimetresPerPixel(sphere.centre);
    const float step = float(m_samples.grid.step);
    const float radius = sphere.radius / (pixel * step);
    if (!(pixel > 0.0f && radius <= largest))
      return false;
    const glm::vec3 behind =
        sphere.centre - sphere.radius * directionTo(m_view.eye(), sphere.centre);
    const float depth = m_view.project(behind).depth;
    if (!(depth > 0.0f && depth < 1.0f))
      return false;
    const glm::vec2 at =
        (m_view.project(sphere.centre).pixel - glm::vec2(m_samples.grid.corner)) / step -
        glm::vec2(float(m_samples.area.x), float(m_samples.area.y)) - 0.5f;
    // Seen aslant it is narrower along its normal, but for what its cone of normals adds.
    const float facing =
        glm::dot(cluster.cone.axis, directionTo(m_view.eye(), sphere.centre)) +
        std::sqrt(std::max(1.0f - cluster.cone.cosine * cluster.cone.cosine, 0.0f));
    const glm::vec2 slant = m_view.projectedDirection(sphere.centre, cluster.cone.axis);
    const float longer = 1.0f / std::clamp(facing, 0.01f, 1.0f);
    const int bottom = std::max(int(std::ceil(at.y - radius)), m_first);
    const int top = std::min(int(std::floor(at.y + radius)) + 1, m_end);
    const int left = std::max(int(std::ceil(at.x - radius)), 0);
    const int right = std::min(int(std::floor(at.x + radius)) + 1, m_samples.area.width);
    for (int row = bottom; row < top; ++row)
      for (int column = left; column < right; ++column) {
        const glm::vec2 away = glm::vec2(float(column), float(row)) - at;
        float& there =
            m_depths[std::size_t(row) * std::size_t(m_samples.area.width) + std::size_t(column)];
        const float across = glm::dot(away, slant);
        const float reach = glm::dot(away, away) + (longer * longer - 1.0f) * across * across;
        if (!(reach <= radius * radius && depth < there))
          continue;
        there = depth;
        putDisc(bandIndex(column, row), cluster, member);
      }
    return true;
  }

  /// Writes the values of a cluster as a whole.
  void putDisc(std::size_t at, const model::Cluster& cluster, const ReadyMember& member) {
    if (!m_owners.empty())
      m_owners[at] = m_member;
    if (!isShaded(member))
      return;
    const model::Surface& surface = member.shown->surface();
    const std::uint32_t vertex = member.clusters->vertices[cluster.firstVertex];
    m_values[normalX][at] = cluster.cone.axis.x;
    m_values[normalY][at] = cluster.cone.axis.y;
    m_values[normalZ][at] = cluster.cone.axis.z;
    const SurfaceFill& fill = member.shading.fill();
    if (fill.byForm)
      m_values[gradient][at] = gradientAt(surface, vertex, surface.mesh->positions()[vertex], fill);
    if (fill.gammaOffsets)
      m_values[gammaOffset][at] = (*fill.gammaOffsets)[vertex];
  }

  /// Takes the values of the cluster's vertices.
  void load(const model::Cluster& cluster, const ReadyMember& member) {
    const model::Surface& surface = member.shown->surface();
    const SurfaceFill& fill = member.shading.fill();
    const std::uint32_t* vertices = member.clusters->vertices.data() + cluster.firstVertex;
    for (std::size_t value = 0; value < sampleValueCount; ++value)
      m_corner[value] = m_loaded[value].data();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const float* row = member.clusters->cornerRow(cluster, 3 + axis))
        m_corner[normalX + axis] = row;
    const bool lookUp = member.clusters->corners.empty();
    for (std::uint32_t i = 0; lookUp && i < cluster.vertexCount; ++i) {
      const glm::vec3 normal = surface.normals[vertices[i]];
      m_loaded[normalX][i] = normal.x;
      m_loaded[normalY][i] = normal.y;
      m_loaded[normalZ][i] = normal.z;
    }
    for (std::uint32_t i = 0; fill.byForm && i < cluster.vertexCount; ++i)
      m_loaded[gradient][i] =
          gradientAt(surface, vertices[i], surface.vertices[vertices[i]].position, fill);
    for (std::uint32_t i = 0; fill.gammaOffsets && i < cluster.vertexCount; ++i)
      m_loaded[gammaOffset][i] = (*fill.gammaOffsets)[vertices[i]];
  }

  bool isEven(const model::Cluster& cluster) const {
    const auto [nearest, farthest] =
        std::minmax_element(m_seen.w.begin(), m_seen.w.begin() + cluster.vertexCount);
    return *farthest <= 1.01f * *nearest;
  }

  /// Returns the shares of the second corner and the third at a place, from those in the picture.
  glm::vec2 inSpace(const std::array<std::uint8_t, 3>& corners, const glm::vec2& share) const {
    if (m_even)
      return share;
    const glm::vec3 nearness((1.0f - share.x - share.y) / m_seen.w[corners[0]],
                             share.x / m_seen.w[corners[1]], share.y / m_seen.w[corners[2]]);
    return glm::vec2(nearness.y, nearness.z) / (nearness.x + nearness.y + nearness.z);
  }

  float gradientAt(const model::Surface& surface, std::uint32_t vertex, const glm::vec3& place,
                   const SurfaceFill& fill) const {
    const model::EyePoint& eye = m_view.eye();
    const glm::vec3 v = directionTo(eye, place);
    const glm::vec3 n = surface.normals[vertex];
    const float distance =
        eye.atInfinity ? std::numeric_limits<float>::infinity() : glm::distance(eye.value, place);
    const glm::vec3 k =
        lightGradient(n, surface.curvature.e1[vertex], surface.curvature.k[vertex], v, distance);
    return fill.filigree * glm::dot(k, v - glm::dot(n, v) * n);
  }

  template <bool shaded>
  void draw(std::size_t i, const std::array<std::uint8_t, 3>& corners) {
    const PixelRect& area = m_samples.area;
    const int left = std::max(m_seen.left[i], area.x) - m_seen.left[i];
    const int right = std::min(m_seen.left[i] + m_seen.columns[i], area.right()) - m_seen.left[i];
    const int bottom = std::max(m_seen.bottom[i], area.y + m_first) - m_seen.bottom[i];
    const int top = std::min(m_seen.bottom[i] + m_seen.rows[i], area.y + m_end) - m_seen.bottom[i];
    if (left >= right || bottom >= top)
      return;
    const auto slopeOf = [i](const SeenCluster::Slopes& slopes) {
      return glm::vec3(slopes.perColumn[i], slopes.perRow[i], slopes.first[i]);
    };
    const glm::vec3 e0 = slopeOf(m_seen.inside[0]);
    const glm::vec3 e1 = slopeOf(m_seen.inside[1]);
    const glm::vec3 e2 = slopeOf(m_seen.inside[2]);
    const glm::vec3 slope = slopeOf(m_seen.steepness);
    // A sliver's slope is steep, and samples may lie beside it by the slack.
    const float least = m_seen.least[i];
    const float most = m_seen.most[i];
    const float perArea = 1.0f / std::max(std::abs(m_seen.area[i]), 1e-20f);
    for (int row = bottom; row < top; ++row) {
      const auto y = float(row);
      const int line = m_seen.bottom[i] + row - area.y;
      const int start = m_seen.left[i] - area.x;
      float* out = m_depths + std::size_t(line) * std::size_t(area.width) + start;
      for (int column = left; column < right; ++column) {
        const auto x = float(column);
        const float in0 = e0.x * x + e0.y * y + e0.z;
        const float in2 = e2.x * x + e2.y * y + e2.z;
        const float inside = std::min(in0, std::min(e1.x * x + e1.y * y + e1.z, in2));
        const float depth = std::min(most, std::max(least, slope.x * x + slope.y * y + slope.z));
        if (!shaded && m_owners.empty() && m_cuts.empty()) {
          out[column] = inside >= 0.0f && depth < out[column] ? depth : out[column];
          continue;
        }
        if (!(inside >= 0.0f && depth < out[column]))
          continue;
        const float b = std::min(in2 * perArea, 1.0f);
        const glm::vec2 share = inSpace(corners, {b, std::min(in0 * perArea, 1.0f - b)});
        if (!m_cuts.empty() && m_cuts.takeAway(corners, share))
          continue;
        out[column] = depth;
        if (!m_owners.empty())
          m_owners[bandIndex(start + column, line)] = m_member;
        if (shaded)
          put(bandIndex(start + column, line), corners, share);
      }
    }
  }

  /// Writes the values of a place that has these shares of the second corner and of the third.
  void put(std::size_t at, const std::array<std::uint8_t, 3>& corners, const glm::vec2& share) {
    const auto mix = [&](std::size_t value) {
      const float* corner = m_corner[value];
      const float a = corner[corners[0]];
      m_values[value][at] =
          a + share.x * (corner[corners[1]] - a) + share.y * (corner[corners[2]] - a);
    };
    for (const std::size_t value : {normalX, normalY, normalZ})
      mix(value);
    const NeededValues& needed = m_members[m_member].shading.needed();
    for (const std::size_t value : {gradient, gammaOffset})
      if (needed[value])
        mix(value);
  }

  std::span<const ReadyMember> m_members;
  const PictureView& m_view;
  const SampleArea& m_samples;
  std::span<const PixelRect> m_rectangles;
  float* m_depths;
  std::uint32_t* m_colours;  ///< null: none are wanted
  SurfaceValues* m_kept;
  NeededValues m_needs{};
  int m_first = 0;
  int m_end = 0;
  std::uint16_t m_member = 0;  ///< that is being drawn
  bool m_even = true;
  ClusterCuts m_cuts;
  SeenCluster m_seen;
  std::array<std::uint8_t, model::Clusters::maximumTriangles> m_holders{};
  std::array<SeenCluster::Vertices, sampleValueCount> m_loaded;
  std::array<const float*, sampleValueCount> m_corner{};     ///< of the cluster's vertices
  std::array<float*, sampleValueCount> m_values{};           ///< from the band's first row on
  std::array<std::vector<float>, sampleValueCount> m_own{};  ///< they lie there, if not kept
  std::vector<std::uint16_t> m_owners;                       ///< who is seen there, of several
};

/// Returns how many rows are drawn together. The fewer bands there are, the fewer clusters lie in
/// two of them, but all threads need some.
int rowsOfBand(const PixelRect& area) {
  constexpr int least = 32;
  constexpr int bandsOfThread = 2;
  const int bands = bandsOfThread * threadCount();
  return std::max(least, (area.height + bands - 1) / bands);
}

/// Draws members band by band. Returns false where a cluster has to be clipped.
bool drawBands(std::span<const ReadyMember> ready, const RasterSight& sight,
               const BandOutput& output) {
  const PixelRect& area = sight.samples.area;
  const std::vector<PlacedCluster> clusters = placedClusters(ready, sight);
  const int bandRows = rowsOfBand(area);
  const auto bands = std::size_t((area.height + bandRows - 1) / bandRows);
  std::vector<std::vector<const PlacedCluster*>> lists(bands);
  for (const PlacedCluster& placed : clusters)
    for (int band = placed.bottom / bandRows; band * bandRows < placed.top; ++band)
      lists[std::size_t(band)].push_back(&placed);
  std::atomic<bool> whole = true;
  parallelChunks(bands, 1, [&](std::size_t begin, std::size_t end) {
    const auto band = std::make_unique<SurfaceBand>(ready, sight, output);
    for (std::size_t i = begin; i < end && whole; ++i) {
      if (lists[i].empty())
        continue;
      const int first = int(i) * bandRows;
      band->setRows(first, std::min(first + bandRows, area.height));
      for (std::size_t k = 0; k < lists[i].size(); ++k) {
        if (k + 2 < lists[i].size())
          __builtin_prefetch(lists[i][k + 2]->cluster);
        if (k + 1 < lists[i].size())
          band->fetch(*lists[i][k + 1]);
        if (!band->add(*lists[i][k])) {
          whole = false;
          return;
        }
      }
      band->shade();
    }
  });
  return whole;
}

}  // namespace

bool rasterise(std::span<const RasterMember> members, const RasterSight& sight,
               const RasterSurface& surface) {
  std::vector<ReadyMember> ready;
  ready.reserve(members.size());
  for (const RasterMember& member : members)
    ready.emplace_back(member, sight);
  return drawBands(ready, sight, {surface.depths, surface.colours});
}

bool findValues(const RasterMember& member, const RasterSight& sight, SurfaceValues& found) {
  const ReadyMember ready(member, sight);
  const PixelRect& area = sight.samples.area;
  const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
  found.depths.assign(count, 1.0f);
  for (std::size_t value = 0; value < sampleValueCount; ++value)
    found.values[value].resize(ready.shading.needed()[value] ? count : 0);
  const bool whole = drawBands({&ready, 1}, sight, {found.depths, {}, &found});
  if (!whole)
    found = {};
  return whole;
}

void shadeValues(const SurfaceFill& fill, const RasterSight& sight, const SurfaceValues& known,
                 const RasterSurface& surface) {
  const SampleShading shading(fill, sight.key);
  const PixelRect& area = sight.samples.area;
  const auto shadeRow = [&](int row, int first, int end) {
    const std::size_t begin = std::size_t(row) * std::size_t(area.width);
    const float* depths = known.depths.data() + begin;
    std::copy(depths + first, depths + end, surface.depths.data() + begin + first);
    for (int column = first; column < end && !surface.colours.empty(); ++column) {
      const int from = column;
      while (column < end && depths[column] < 1.0f)
        ++column;
      if (column == from)
        continue;
      ValueSpans values{};
      for (std::size_t value = 0; value < sampleValueCount; ++value)
        if (shading.needed()[value])
          values[value] = known.values[value].data() + begin + from;
      shading.shade(sight.view, sight.samples, {row, from, column}, values,
                    surface.colours.data() + begin + from);
    }
  };
  constexpr int bandRows = 32;
  parallelFor(std::size_t((area.height + bandRows - 1) / bandRows), 1, [&](std::size_t band) {
    const int bottom = int(band) * bandRows;
    for (const PixelRect& rect : sight.rectangles)
      for (int row = std::max(rect.y, bottom); row < std::min(rect.top(), bottom + bandRows); ++row)
        shadeRow(row, rect.x, rect.right());
  });
}

}  // namespace sline::render
