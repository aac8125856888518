// SPDX-License-Identifier: Apache-2.0
// Computes what a stroke of a brush paints on a surface. The brush is a disc in the picture and
// paints what one sees of the surface within it, as brushes of programs for sculpture do: other
// structures are no obstacle, the surface itself is. No window.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "model/base/units.h"
#include "model/geometry/mesh_trees.h"
#include "model/geometry/paint.h"
#include "model/geometry/plane.h"
#include "model/scene/camera.h"

namespace sline::widgets {

struct Brush {
  float radius = 40.0f;   ///< pixels
  float softness = 0.5f;  ///< 0: alike up to the rim, 1: weaker from the middle on
  float strength = 1.0f;  ///< how much of the way a stroke goes in its middle, 0 … 1
  bool erases = false;
  bool operator==(const Brush&) const = default;
};
inline constexpr Limits<float> brushRadii{4.0f, 300.0f};

/// Returns how strongly the brush works at that distance from its middle, 0 … its strength.
float brushWeight(const Brush& brush, float pixels);

/// Holds a surface ready to be painted on.
struct BrushGround {
  model::MeshPtr mesh;
  model::BvhPtr tree;
  std::vector<glm::vec3> normals;
};
using BrushGroundPtr = std::shared_ptr<const BrushGround>;
BrushGroundPtr brushGround(const model::MeshPtr& mesh);

class BrushStroke {
 public:
  struct Start {
    BrushGroundPtr ground;
    model::PaintPtr before;  ///< what is painted on the mesh; null: nothing
    model::Camera camera;
    glm::vec2 size{1.0f};              ///< of the picture, pixels
    std::vector<model::Plane> planes;  ///< of the sections that cut it
    Brush brush;
  };
  explicit BrushStroke(Start start);

  /// Moves the brush from one pixel straight to another; tells whether that has changed the paint.
  /// However often a stroke passes a place, it works there once, as strongly as where it came
  /// nearest.
  bool move(const glm::vec2& from, const glm::vec2& to);
  /// Returns what is painted by now.
  model::PaintPtr paint() const { return std::make_shared<const model::Paint>(m_paint); }

 private:
  enum class Sight : std::uint8_t { unknown, seen, hidden };
  void placeVertices();
  void sortIntoCells();
  std::size_t cellAt(float x, float y) const;
  bool sees(std::uint32_t vertex) const;
  /// Returns the corner nearest to where the line of sight meets the surface.
  std::vector<std::uint32_t> cornerAt(const glm::vec2& pixel) const;
  bool cover(std::uint32_t vertex, float weight);

  Start m_start;
  float m_lift = 0.0f;              ///< millimetres from the surface, from where it is looked
  std::vector<glm::vec2> m_pixels;  ///< of the vertices; not a number for those turned away
  std::size_t m_columns = 1;        ///< cells of the picture
  std::size_t m_rows = 1;
  std::vector<std::uint32_t> m_cellStarts;  ///< in m_inCells, one more than there are cells
  std::vector<std::uint32_t> m_inCells;     ///< vertices, cell by cell
  std::vector<Sight> m_sights;
  std::vector<float> m_covered;  ///< how strongly the stroke has worked at each vertex
  model::Paint m_before;
  model::Paint m_paint;
};

}  // namespace sline::widgets
