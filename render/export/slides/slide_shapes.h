// SPDX-License-Identifier: Apache-2.0
// Writes labels and marks as shapes of DrawingML (ECMA-376 part 1, §20.1, §19.3.1): leaders as
// connectors, dots as ellipses, texts as text boxes, those of one label in a group of its name.
#pragma once

#include <string>

#include "render/export/slides/slide_deck.h"

namespace sline::render {

/// Returns `<a:off …/><a:ext …/>`.
std::string slidePlace(const SlideBox& box);

/// Writes shapes onto one slide, and numbers everything on it.
class SlideShapes {
 public:
  /// Places are those of the figure's page, which is at `figure` on the slide.
  SlideShapes(const SlideDeck& deck, const SlideBox& figure) : m_deck(deck), m_figure(figure) {}

  /// Returns the next number of a shape; the slide itself has 1.
  int nextId() { return ++m_id; }
  /// Returns the attributes that name a shape: its number and name.
  std::string named(const std::string& name) { return named(nextId(), name); }
  /// Returns the label: a text box, or its group where there are shapes; `id` receives its number.
  std::string label(const SlideLabel& label, int* id = nullptr);

 private:
  struct Text;
  static std::string named(int id, const std::string& name);
  std::string connectors(const LetteringShape& shape, const std::vector<glm::vec2>& points,
                         const Text* text);
  std::string drawn(const LetteringShape& shape, const Text* text);
  std::string textBox(const Text& text, const std::string& name);
  std::string body(const Text& text) const;
  std::string lines(const Text& text) const;
  std::string outline(const LetteringShape& shape) const;
  std::string glow(float haloMm) const;
  std::string colour(const Colour& colour) const;
  glm::vec2 onSlide(const glm::vec2& place) const { return m_figure.at + slideScale * place; }
  void extend(const SlideBox& box);

  const SlideDeck& m_deck;
  SlideBox m_figure;
  int m_id = 1;
  glm::vec2 m_low{0.0f};  ///< the extent of the group at hand
  glm::vec2 m_high{0.0f};
};

}  // namespace sline::render
