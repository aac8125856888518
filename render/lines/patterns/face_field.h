// SPDX-License-Identifier: Apache-2.0
// Samples a cut face on a grid in its plane: which places lie on it, and how far from its rim.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/lines/patterns/cut_faces.h"

namespace sline::render {

/// A rectangle in a plane's own coordinates: ⟨u, p⟩ and ⟨v, p⟩ of model::axesOf, mm.
struct PlaneWindow {
  glm::dvec2 low{0.0};
  glm::dvec2 high{0.0};
  bool operator==(const PlaneWindow&) const = default;
};

/// Returns the least rectangle around the face's triangles; nothing where it has none.
std::optional<PlaneWindow> windowOf(const CutFace& face);

class FaceField {
 public:
  /// Samples the part of the face within the window at cells of that size. The cells' places
  /// depend on their size alone, so that they stay where they are when the window moves.
  FaceField(const CutFace& face, const PlaneWindow& window, double cell);

  /// Returns the distance to the rim in mm, 0 outside the face and the window. It is right to
  /// about one and a half cells; the window's own edge is no rim.
  double rim(const glm::dvec2& p) const;
  /// Returns the unit direction in which that distance grows; zero where there is none.
  glm::dvec2 inwards(const glm::dvec2& p) const;
  PlaneWindow window() const;
  double cell() const { return m_cell; }

 private:
  void fill(const CutFace& face);
  void measure();
  float rimOf(std::ptrdiff_t x, std::ptrdiff_t y) const {
    return x < 0 || y < 0 || x >= m_width || y >= m_height
               ? 0.0f
               : m_rim[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
  }

  double m_cell;
  glm::dvec2 m_low{0.0};  ///< the middle of the first cell
  std::ptrdiff_t m_width = 0;
  std::ptrdiff_t m_height = 0;
  std::vector<float> m_rim;  ///< mm, row by row
};

}  // namespace sline::render
