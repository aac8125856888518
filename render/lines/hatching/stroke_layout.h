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
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "model/geometry/surface.h"
#include "render/lines/hatching/hatch_seeds.h"
#include "render/lines/hatching/stroke_spacing.h"
#include "render/lines/hatching/surface_walk.h"

namespace sline::render {

/// The most cells of a layout that are looked at for a surface. A usual picture looks at some
/// hundred; but a flat side that is seen along its length has cells all the way to the horizon.
inline constexpr std::size_t mostHatchCells = 20'000;

/// A place on the mesh, stored in eight bytes.
struct LaidPoint {
  std::uint32_t slot = 0;    ///< of the triangle, in Clusters::triangles
  std::uint16_t second = 0;  ///< barycentric coordinate of corner 1, in 65535ths
  std::uint16_t third = 0;   ///< of corner 2
};

struct LaidStroke {
  HatchSeed seed;
  model::Sphere bounds;
  model::NormalCone cone;       ///< of the normals at its points
  std::uint32_t first = 0;      ///< in LaidTile::points
  std::uint32_t count = 0;      ///< 1 for a dot
  std::uint32_t seedPoint = 0;  ///< counted from its first
  std::uint32_t firstRow = 0;   ///< how long the rows of the tile's strokes before it are together
  float bendingStep = 0.0f;     ///< of LaidTile::shape, 1/mm

  /// Returns the numbers in a row: whole registers of the processor.
  std::uint32_t rowLength() const { return (count + 7u) & ~7u; }
};

/// What a view needs to know of a stroke's points lies in rows, one number of all its points after
/// the other, and stroke by stroke, so that the processor works on several points at once and waits
/// for none. Rows go on with the last position, and zeros of shape.
struct LaidTile {
  static constexpr float normalSteps = 32767.0f;
  static constexpr std::size_t shapeRows = 9;

  std::vector<LaidPoint> points;
  std::vector<LaidStroke> strokes;
  std::vector<float> positions;  ///< rows x, y, z of each stroke, patient frame, mm
  /// Rows of the unit normal, in 32767ths, and of the shape operator (xx, xy, xz, yy, yz, zz; see
  /// model::TensorBounds), in the stroke's steps.
  std::vector<std::int16_t> shape;

  /// `positionRow` and `shapeRow` return a row of a stroke; `position` and `normal` (of about unit
  /// length) what it says of one of its points.
  const float* positionRow(const LaidStroke& stroke, std::size_t row) const {
    return positions.data() + 3 * std::size_t(stroke.firstRow) + row * stroke.rowLength();
  }
  const std::int16_t* shapeRow(const LaidStroke& stroke, std::size_t row) const {
    return shape.data() + shapeRows * stroke.firstRow + row * stroke.rowLength();
  }
  glm::vec3 position(const LaidStroke& stroke, std::size_t point) const {
    const float* x = positionRow(stroke, 0) + point;
    return {x[0], x[stroke.rowLength()], x[2 * std::size_t(stroke.rowLength())]};
  }
  glm::vec3 normal(const LaidStroke& stroke, std::size_t point) const {
    const std::int16_t* n = shapeRow(stroke, 0) + point;
    return glm::vec3(n[0], n[stroke.rowLength()], n[2 * std::size_t(stroke.rowLength())]) /
           normalSteps;
  }
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

/// A cell that strokes may start in, as a layout keeps it: it stays where it is.
struct KeptCell {
  LaidCell cell;
  std::size_t number = 0;               ///< counted from 0 in each layout
  std::vector<std::uint32_t> clusters;  ///< that strokes starting there may reach, ascending
  // The layout's own, guarded by its mutex.
  bool knowsFiner = false;
  std::vector<const KeptCell*> finer;    ///< see StrokeLayout::finer
  std::shared_ptr<const LaidTile> tile;  ///< null until it is laid
  std::uint32_t lastView = 0;
};

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
  /// Returns the coarsest level that has more than a stroke or two, and the finest whose strokes
  /// lie farther apart than coordinates are rounded; that is less than the first where none is.
  int firstLevel() const { return m_firstLevel; }
  int lastLevel() const { return m_lastLevel; }

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
  /// those of the last view, those that were not asked for the longest are forgotten, and laid
  /// again, identically, if they are needed.
  void beginView();
  std::shared_ptr<const LaidTile> tile(const LaidCell& cell);
  std::shared_ptr<const LaidTile> tile(const KeptCell& cell);
  /// Returns the cells from which to go on to finer ones, of a level that has few of them all over
  /// the surface: the first, or a coarser one, whose cells have no strokes.
  const std::vector<const KeptCell*>& coarsest();
  /// Returns those of the next level that share space with the cell.
  const std::vector<const KeptCell*>& finer(const KeptCell& cell);
  /// Returns how many cells have got a number so far.
  std::size_t keptCount();

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
  struct CellHash {
    std::size_t operator()(const LaidCell& cell) const {
      std::uint64_t h = std::uint32_t(cell.level);
      for (const std::int32_t at : {cell.x, cell.y, cell.z})
        h = (h ^ std::uint32_t(at)) * 0x9e3779b97f4a7c15u;
      return std::size_t(h ^ (h >> 32));
    }
  };
  KeptCell& kept(const LaidCell& cell);
  KeptCell& keep(const LaidCell& cell, std::vector<std::uint32_t> clusters);
  std::vector<const KeptCell*> reaching(const CellRange& range);
  std::vector<std::uint32_t> clustersWithin(const model::Box& box) const;
  std::shared_ptr<const LaidTile> found(KeptCell& known);
  LaidTile lay(const KeptCell& known);
  int lastLevelApart() const;
  int levelOfFewCells() const;
  void markAround(const LaidCell& cell, const model::Box& box, StrokeSpacing& taken);
  StrokeSpacing::Mark markAt(const SurfacePoint& place) const;
  static void mark(const LaidTile& tile, const LaidStroke& stroke, float distance,
                   StrokeSpacing& taken);

  model::SurfacePtr m_surface;
  std::vector<std::uint32_t> m_slots;  ///< of each triangle, in Clusters::triangles
  model::FaceNeighbours m_neighbours;
  StrokeDirections m_directions;
  float m_length;
  int m_firstLevel;
  int m_lastLevel;
  std::mutex m_mutex;  ///< guards all below
  std::unordered_map<LaidCell, KeptCell, CellHash> m_cells;
  std::vector<KeptCell*> m_byNumber;
  bool m_knowsCoarsest = false;
  std::vector<const KeptCell*> m_coarsest;
  std::size_t m_points = 0;  ///< in all tiles
  std::size_t m_shown = 0;   ///< in tiles that the view has asked for
  std::uint32_t m_view = 0;
};

}  // namespace sline::render
