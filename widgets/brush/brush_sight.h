// SPDX-License-Identifier: Apache-2.0
// Finds what one sees of a surface in a picture, vertex by vertex, for a brush that paints on it.
// No window.
#pragma once

#include <cstdint>
#include <future>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/mesh_trees.h"
#include "model/geometry/plane.h"

namespace sline::widgets {

/// Holds a surface ready to be painted on.
struct BrushGround {
  model::MeshPtr mesh;
  model::BvhPtr tree;
  std::vector<glm::vec3> normals;
};
using BrushGroundPtr = std::shared_ptr<const BrushGround>;
BrushGroundPtr brushGround(const model::MeshPtr& mesh);

/// Sorts a surface's vertices by their places in a picture, and looks with a ray for each whether
/// the surface itself hides it; each ray is sent once.
class BrushSight {
 public:
  struct From {
    BrushGroundPtr ground;
    model::Camera camera;
    glm::vec2 size{1.0f};              ///< of the picture, pixels
    std::vector<model::Plane> planes;  ///< of the sections that cut the surface
    bool operator==(const From&) const = default;
  };
  explicit BrushSight(From from);

  const From& from() const { return m_from; }
  /// Calls visit(vertex, pixel) for the vertices in the cells that the rectangle touches which are
  /// turned to the eye and not known to be hidden.
  template <class Visit>
  void visit(const glm::vec2& low, const glm::vec2& high, const Visit& visit) const;
  /// Finds out which of them are seen.
  void look(std::span<const std::uint32_t> vertices);
  /// Finds it out for all that lie in the picture, until that is stopped.
  void lookEverywhere(const std::stop_token& stop);
  /// Tells whether a vertex was looked for and is seen.
  bool sees(std::uint32_t vertex) const { return m_sights[vertex] == Sight::seen; }
  /// Returns the corner nearest to where the line of sight meets the surface.
  std::optional<std::uint32_t> cornerAt(const glm::vec2& pixel) const;

 private:
  enum class Sight : std::uint8_t { unknown, seen, hidden };
  void placeVertices();
  void sortIntoCells();
  std::size_t cellAt(float x, float y) const;
  bool reaches(std::uint32_t vertex) const;

  From m_from;
  float m_lift = 0.0f;              ///< millimetres from the surface, from where it is looked
  std::vector<glm::vec2> m_pixels;  ///< of the vertices; not a number for those turned away
  std::size_t m_columns = 1;        ///< cells of the picture
  std::size_t m_rows = 1;
  std::vector<std::uint32_t> m_cellStarts;  ///< in m_inCells, one more than there are cells
  std::vector<std::uint32_t> m_inCells;     ///< vertices, cell by cell
  std::vector<Sight> m_sights;
};
using BrushSightPtr = std::shared_ptr<BrushSight>;

template <class Visit>
void BrushSight::visit(const glm::vec2& low, const glm::vec2& high, const Visit& visit) const {
  const std::size_t first = cellAt(low.x, low.y);
  const std::size_t last = cellAt(high.x, high.y);
  for (std::size_t row = first / m_columns; row <= last / m_columns; ++row)
    for (std::size_t column = first % m_columns; column <= last % m_columns; ++column) {
      const std::size_t cell = row * m_columns + column;
      for (std::uint32_t i = m_cellStarts[cell]; i < m_cellStarts[cell + 1]; ++i)
        if (const std::uint32_t v = m_inCells[i]; m_sights[v] != Sight::hidden)
          visit(v, m_pixels[v]);
    }
}

/// Looks ahead, in the background, from where a brush hovers, so that a stroke that begins there
/// has nothing left to find out.
class SightAhead {
 public:
  ~SightAhead() { m_stop.request_stop(); }
  /// Begins to look from there, unless that is done or under way.
  void want(const BrushSight::From& from);
  /// Returns what one sees from there, as far as it has been looked.
  BrushSightPtr take(const BrushSight::From& from);
  /// Tells whether what was wanted last has been seen and waits to be taken.
  bool arrived() const;
  void forget();

 private:
  BrushSightPtr m_known;
  BrushSight::From m_wanted;
  std::stop_source m_stop;
  std::future<BrushSightPtr> m_coming;
};

}  // namespace sline::widgets
