// SPDX-License-Identifier: Apache-2.0
// Finds where a mark may stand.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/labels/seen/seen_map.h"
#include "render/labels/seen/shapes.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Knows what is free of a page: what neither its edge nor another mark nor anatomy takes. Lengths
/// are millimetres of the output.
class FreePlaces {
 public:
  /// Takes the boxes that are taken already, and what the picture shows, where that is known: null
  /// for a picture that is yet to be fitted or whose marks must not move, as in films.
  FreePlaces(const glm::vec2& page, std::vector<LabelBox> taken, const SeenArea* drawn);

  /// Says that the page ends there from now on.
  void setPage(const glm::vec2& page) { m_page = page; }
  void take(const LabelBox& box) { m_taken.push_back(box); }
  /// Tells whether the box lies on the page, on no box that is taken and, with some air around it,
  /// on nothing that is drawn.
  bool free(const LabelBox& box) const;
  /// Returns by how much the box must be moved to be free: not at all, else the least along one of
  /// the directions (unit vectors) there or back, those named first being tried first. Nothing is
  /// returned where it is free nowhere.
  std::optional<glm::vec2> shift(const LabelBox& box, std::span<const glm::vec2> along) const;
  /// Returns by how much both boxes must be moved, by the same, to be free: not at all, else the
  /// least along the direction there or back. Nothing is returned where they are free together
  /// nowhere.
  std::optional<glm::vec2> shiftTogether(const LabelBox& one, const LabelBox& other,
                                         const glm::vec2& along) const;
  /// Returns the upper left corner of a free box of that size: in the page's lower right corner,
  /// else in one of the others or above or below it, else nothing. Where it is not known what the
  /// picture shows, it is the lower right one.
  std::optional<glm::vec2> corner(const glm::vec2& size) const;

 private:
  glm::vec2 m_page;
  std::vector<LabelBox> m_taken;
  const SeenArea* m_drawn;
};

/// Returns the item, moved.
LetteringItem movedBy(LetteringItem item, const glm::vec2& by);

}  // namespace sline::render
