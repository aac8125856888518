// SPDX-License-Identifier: Apache-2.0
// Draws one structure by itself into coarse cells: how near it is in each, with which triangle, and
// whether its outline passes there. Made on the CPU, so that labels know what a picture shows
// wherever it is made.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/plane.h"
#include "model/scene/scene.h"
#include "render/labels/seen/screen.h"
#include "render/labels/seen/seen_look.h"
#include "render/sight/flat_triangle.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

/// The cells of a picture.
struct SeenGrid {
  int columns = 1;
  int rows = 1;
  float side = 1.0f;       ///< of a cell, millimetres of the output
  glm::vec2 corner{0.0f};  ///< the upper left one, millimetres of the output

  glm::vec2 middle(int x, int y) const { return corner + side * (glm::vec2(x, y) + 0.5f); }
};

struct SeenCell {
  float depth = 0.0f;  ///< as Screen::depthKey has it
  std::uint32_t triangle = 0;
  float facing = 1.0f;  ///< cosine between the surface's normal and the line of sight
  enum class What : std::uint8_t { nothing, surface, cutFace, beside } what = What::nothing;
  bool outline = false;   ///< the structure's outline runs through it
  float ink = 0.0f;       ///< the share of it that the outline's pen covers
  std::uint8_t face = 0;  ///< of a cut face: the section's number
};

class SeenLayer {
 public:
  SeenLayer(const model::Scene& scene, const model::Node& node, const model::ResolvedStyle& style,
            bool onDark);

  /// Draws the structure as its sections leave it; its outlines are where its cells end. Its cut
  /// faces lie before and behind others of their plane as in pictures (faceSteps).
  void draw(const model::Scene& scene, const Screen& screen, const SeenGrid& grid);
  /// Draws it with the curves that pictures have (METHOD §11), after its surface was taken: takes
  /// longer. Cells must be λ wide and the grid must be the whole picture's.
  void drawAsInPictures(const model::Scene& scene, const Screen& screen, const SeenGrid& grid);

  /// Makes the surface that pictures have, with the steps of slices taken out and smooth normals.
  model::SurfacePtr pictured() const;
  /// Takes that surface: it is drawn instead of the mesh from now on.
  void takeSurface(model::SurfacePtr surface);
  /// Returns the same structure with nothing drawn.
  SeenLayer undrawn() const;

  const model::Node& node() const { return *m_node; }
  const SeenLook& look() const { return m_look; }
  const std::vector<model::Plane>& planes() const { return m_planes; }
  /// Returns the fill that a cell shows if its surface is bent that much (SeenLook).
  SeenFill fillOf(const SeenCell& cell, float bent = 0.0f) const;
  /// The cells that may hold something: columns from `left()` on, rows from `top()` on.
  int left() const { return m_left; }
  int top() const { return m_top; }
  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  /// Returns the cell of the whole grid; one with nothing where there is none.
  const SeenCell& at(int x, int y) const {
    const bool inside = x >= m_left && y >= m_top && x < m_left + m_columns && y < m_top + m_rows;
    return inside ? m_cells[index(x, y)] : m_none;
  }
  bool covers(int x, int y) const {
    const SeenCell::What what = at(x, y).what;
    return what == SeenCell::What::surface || what == SeenCell::What::cutFace;
  }
  /// Tells whether another surface that is no nearer than this one's cell may hide it all the same:
  /// the two touch, and which of them a picture shows changes from pixel to pixel. Of cut faces
  /// that are not equally large it is known.
  bool touches(const SeenCell& cell, const SeenCell& other) const {
    return other.depth >= cell.depth && other.depth < cell.depth + slackBetween(cell, other);
  }
  /// Tells whether this surface may be what a picture shows of the two, as it is nearer or touches
  /// the other.
  bool mayLieBefore(const SeenCell& cell, const SeenCell& other) const {
    return cell.depth < other.depth + slackBetween(cell, other);
  }
  /// Tells whether two cells show faces of one cut, of which none lies in front of the other.
  bool inOneFace(const SeenCell& cell, const SeenCell& other) const {
    constexpr float lifts = 2e-4f;  // the most that faces of a plane are apart
    return cell.what == SeenCell::What::cutFace && other.what == cell.what &&
           std::abs(cell.depth - other.depth) <= m_touch + lifts * std::abs(cell.depth);
  }
  /// Tells whether the cell shows a cut face without colour of its own.
  bool isPaper(const SeenCell& cell) const {
    return cell.what == SeenCell::What::cutFace &&
           m_look.cutFace(facesOf(cell), m_pattern).colour <= 0.0f;
  }
  /// Tells whether anything of it is left by sections, in the picture or not.
  bool remains() const { return m_remains; }
  /// Returns the point of the surface that a cell shows, and where the output shows it.
  struct Spot {
    model::Anchor anchor;
    glm::vec2 place{0.0f};
  };
  Spot spotAt(const Screen& screen, const SeenGrid& grid, int x, int y) const;
  /// Returns the nearest cell that the surface covers, at most `far` cells away.
  std::optional<glm::ivec2> coveredNear(int x, int y, int far) const;
  /// Returns the unit vector in the picture that leads out of the surface at a cell, if its outline
  /// there bounds a body and is no thin strip, end or fold of it.
  std::optional<glm::vec2> outwards(int x, int y) const;

 private:
  SeenLayer(const model::Node& node, const model::ResolvedStyle& style, const SeenLook& look);
  struct PenPoint {
    glm::vec2 on{0.0f};     ///< the line itself, cells
    glm::vec2 place{0.0f};  ///< where the pen draws it
    glm::vec2 outward{0.0f};
    float depth = 0.0f;
    float lifted = 0.0f;  ///< the depth at which it hides and is hidden by others
    float halfWidth = 0.5f;
    float opacity = 1.0f;
  };
  struct Corner {
    glm::vec2 cell{0.0f};
    float depth = 0.0f;
    bool seen = false;
  };
  std::size_t index(int x, int y) const {
    return std::size_t(y - m_top) * std::size_t(m_columns) + std::size_t(x - m_left);
  }
  void project(const Screen& screen, const SeenGrid& grid);
  FlatTriangle flat(const Screen& screen, const model::Triangle& triangle) const;
  void drawTriangle(const Screen& screen, std::uint32_t triangle);
  void take(int x, int y, const SeenCell& cell);
  model::CutFaces facesOf(const SeenCell& cell) const {
    return cell.face < m_faces.size() ? m_faces[cell.face] : model::CutFaces::tissue;
  }
  float slackBetween(const SeenCell& cell, const SeenCell& other) const {
    const bool cuts = cell.what == SeenCell::What::cutFace && other.what == cell.what;
    constexpr float oneStep = 4e-7f;  // of faces as large as each other (inFront)
    return cuts ? oneStep * std::abs(cell.depth) : m_touch;
  }
  void findCutFaces(const model::Scene& scene, const Screen& screen, const SeenGrid& grid);
  void findOutlines(float pen);
  void drawCurves(const StructureLines& drawn, const model::Surface& surface, const Screen& screen,
                  const PictureView& view);
  bool showsAt(PenPoint& point, const ContourProbes& probes, float tolerance) const;
  void takeInk(const PenPoint& point, std::vector<float>& depths);
  float distanceAt(const glm::vec2& cell) const;
  void plotSmall(const Screen& screen);

  const model::Node* m_node;
  model::MeshPtr m_mesh;        ///< the one that is drawn, of the node's triangles
  model::SurfacePtr m_surface;  ///< the one that pictures have, if it was taken
  model::ResolvedStyle m_style;
  SeenLook m_look;
  bool m_perspective = true;
  std::vector<model::Plane> m_planes;
  std::vector<model::CutFaces> m_faces;  ///< one for each plane
  model::CutPattern m_pattern = model::CutPattern::plain;
  bool m_patternKnown = false;
  std::vector<Corner> m_corners;
  int m_left = 0;
  int m_top = 0;
  int m_columns = 0;
  int m_rows = 0;
  float m_side = 1.0f;
  float m_fold = 1.0f;   ///< a step in depth that makes an outline
  float m_touch = 0.0f;  ///< one that is too small to tell
  bool m_remains = false;
  std::vector<SeenCell> m_cells;
  SeenCell m_none;
};

}  // namespace sline::render
