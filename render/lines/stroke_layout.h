// SPDX-License-Identifier: Apache-2.0
// Lays strokes over a surface once, for all views. Strokes of level l are `spacing(l)` apart and
// lie between those of the coarser levels. A view draws coarse strokes in full and lets finer ones
// grow in between as it comes nearer (nested like the tonal art maps of E. Praun et al., "Real-Time
// Hatching", 2001), so that neither turning nor zooming moves a stroke or takes one away (METHOD
// §6.7, §6.10).
//
// Levels are laid in cubes, each when a view first needs it, so that a close look costs no more
// than a far one. The content of a cube does not depend on when it is laid: it makes way for all
// coarser cubes nearby and for those neighbours of its level that come before it in an order by the
// parity of their coordinates, and for nothing else.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "model/geometry/surface.h"
#include "render/lines/hatch_seeds.h"
#include "render/lines/stroke_spacing.h"
#include "render/lines/surface_walk.h"

namespace sline::render {

/// A place on the mesh, stored in eight bytes.
struct LaidPoint {
  std::uint32_t slot = 0;    ///< of the triangle, in Clusters::triangles
  std::uint16_t second = 0;  ///< barycentric coordinate of corner 1, in 65535ths
  std::uint16_t third = 0;   ///< of corner 2
};

/// Points of a stroke in a row that lie in one cluster.
struct LaidRun {
  std::uint32_t cluster = 0;
  std::uint32_t end = 0;  ///< one past the last, in LaidTile::points
};

struct LaidStroke {
  HatchSeed seed;
  model::Sphere bounds;
  std::uint32_t first = 0;  ///< in LaidTile::points
  std::uint32_t count = 0;  ///< 1 for a dot
  std::uint32_t seedPoint = 0;
  std::uint32_t firstRun = 0;  ///< in LaidTile::runs; the last is the one that ends with the stroke
};

struct LaidTile {
  std::vector<LaidPoint> points;
  std::vector<glm::vec3> positions;  ///< of the points, patient frame, mm
  std::vector<LaidStroke> strokes;
  std::vector<LaidRun> runs;
};

/// A cell is a cube of one level. Odd cubes lie between even ones; the cube at the origin lies
/// around the origin.
struct LaidCell {
  int level = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  auto operator<=>(const LaidCell&) const = default;
};

/// Holds the cells of one level from `low` to `high` along each axis, both included.
struct CellRange {
  int level = 0;
  glm::vec3 low{0.0f};  ///< whole numbers, as floats, which hold values too large for a cell
  glm::vec3 high{-1.0f};

  double count() const {
    const glm::dvec3 n = glm::max(glm::dvec3(high) - glm::dvec3(low) + 1.0, glm::dvec3(0.0));
    return n.x * n.y * n.z;
  }
  template <class Body>
  void forEach(const Body& body) const {
    for (float z = low.z; z <= high.z; z += 1.0f)
      for (float y = low.y; y <= high.y; y += 1.0f)
        for (float x = low.x; x <= high.x; x += 1.0f)
          body(LaidCell{level, std::int32_t(x), std::int32_t(y), std::int32_t(z)});
  }
};

bool touches(const model::Sphere& sphere, const model::Box& box);

/// Keeps the strokes of one surface; several threads may use it.
class StrokeLayout {
 public:
  /// Takes the length of the longest stroke as a multiple of the distance between strokes; 0 for
  /// dots.
  StrokeLayout(model::SurfacePtr surface, float length);

  const model::Surface& surface() const { return *m_surface; }
  float length() const { return m_length; }
  /// Returns the distance between strokes of a level, mm.
  float spacing(int level) const;
  /// Returns the coarsest level that has more than a stroke or two.
  int firstLevel() const { return m_firstLevel; }

  /// `home` returns the cube itself, in the patient's frame; `reached` all that strokes starting
  /// there may reach.
  model::Box home(const LaidCell& cell) const;
  model::Box reached(const LaidCell& cell) const;
  /// Returns the cells of a level that share space with the box.
  CellRange rangeWithin(int level, const model::Box& box) const;
  std::vector<LaidCell> cellsWithin(int level, const model::Box& box) const;
  /// Returns the cells from which strokes may reach into the sphere.
  CellRange rangeNear(int level, const model::Sphere& sphere) const;
  std::vector<LaidCell> cellsNear(int level, const model::Sphere& sphere) const;
  /// Must be called before a view asks for its cells. Where strokes take much more memory than
  /// those of the last view, cells that were not asked for the longest are forgotten, and laid
  /// again, identically, if they are needed.
  void beginView();
  std::shared_ptr<const LaidTile> tile(const LaidCell& cell);
  /// Returns the clusters that strokes starting in the cell may reach, ascending.
  std::shared_ptr<const std::vector<std::uint32_t>> clustersReached(const LaidCell& cell);

  static glm::vec3 barycentric(const LaidPoint& point) {
    const float second = float(point.second) / 65535.0f;
    const float third = float(point.third) / 65535.0f;
    return {1.0f - second - third, second, third};
  }
  SurfacePoint at(const LaidPoint& point) const;
  glm::vec3 position(const LaidPoint& point) const;

 private:
  class Placer;
  float reach(int level) const;
  float side(int level) const;
  struct KeptCell {
    std::shared_ptr<const std::vector<std::uint32_t>> clusters;  ///< see `clustersReached`
    std::shared_ptr<const LaidTile> tile;                        ///< null until it is laid
    std::uint32_t lastView = 0;
  };
  struct CellHash {
    std::size_t operator()(const LaidCell& cell) const {
      std::uint64_t h = std::uint32_t(cell.level);
      for (const std::int32_t at : {cell.x, cell.y, cell.z})
        h = (h ^ std::uint32_t(at)) * 0x9e3779b97f4a7c15u;
      return std::size_t(h ^ (h >> 32));
    }
  };
  KeptCell& kept(const LaidCell& cell);
  std::shared_ptr<const LaidTile> found(const LaidCell& cell);
  LaidTile lay(const LaidCell& cell);
  void markAround(const LaidCell& cell, const model::Box& box, StrokeSpacing& taken);
  StrokeSpacing::Mark markAt(const SurfacePoint& place) const;
  void mark(const LaidTile& tile, const LaidStroke& stroke, float distance,
            StrokeSpacing& taken) const;

  model::SurfacePtr m_surface;
  std::vector<std::uint32_t> m_slots;  ///< of each triangle, in Clusters::triangles
  model::FaceNeighbours m_neighbours;
  StrokeDirections m_directions;
  float m_length;
  int m_firstLevel;
  std::mutex m_mutex;  ///< guards the cells
  std::unordered_map<LaidCell, KeptCell, CellHash> m_cells;
  std::size_t m_points = 0;  ///< in all tiles
  std::size_t m_shown = 0;   ///< in tiles that the view has asked for
  std::uint32_t m_view = 0;
};

}  // namespace sline::render
