// SPDX-License-Identifier: Apache-2.0
// Breaks texts of labels into lines and measures them.
#pragma once

#include <QFont>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "render/labels/anchors.h"
#include "render/lettering/label_font.h"
#include "render/lettering/label_style.h"
#include "render/lettering/text_lines.h"

namespace sline::render {

/// Tells how wide a word may be that has no place to divide it, and its parts where it is wider,
/// each with a hyphen where its script has hyphens. Millimetres.
struct WordRoom {
  float whole = std::numeric_limits<float>::infinity();
  float part = std::numeric_limits<float>::infinity();
};

struct LabelText {
  std::vector<TextLine> lines;
  bool list = false;    ///< some lines are items: all begin at the same side in any column
  glm::vec2 box{0.0f};  ///< millimetres, with padding
};

/// Returns what a key says of the label: its words without markup, with a distance's length after
/// them.
std::string keyText(const ShownLabel& label, const LabelStyle& style);

/// Returns the width of the line's runs one after the other, without its indent, in the font's
/// pixels.
qreal advanceOf(const TextLine& line);
/// Returns the width of the line with its indent in that size, millimetres.
float textWidthMm(const TextLine& line, float points);
/// Returns the height of capitals, millimetres.
float capHeightMm(float points);

/// Returns the space around the text within its box, millimetres.
glm::vec2 paddingOf(model::AnnotationKind kind, const LabelStyle& style);
float lineHeightMm(const LabelStyle& style);
/// Returns the width of a blank line, which is the same for every text so that it gives nothing
/// away.
float blankWidthMm(const LabelStyle& style);
/// Returns the label's text in lines. A distance has its length, in the language's digits, after
/// its text. A callout's text is marked up (model/scene/markup.h), and its lines also begin where
/// the author began them. Lines are broken between words so that none is wider than `widestMm`, and
/// within wider words where their script or names that programs join allow it; elsewhere only if a
/// word is wider than the room for words. A text that fits on no page is cut short.
LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm,
                 const WordRoom& words = {});
/// Returns the largest width of lines of labels in a picture of that width; only single words may
/// be wider.
float widestTextMm(float pictureWidthMm, const LabelStyle& style);
/// Returns the room for words in such a picture.
WordRoom wordRoom(float pictureWidthMm, const LabelStyle& style);

/// Measures a label's words once, so that many widths can be tried.
class MeasuredText {
 public:
  MeasuredText(const ShownLabel& label, const LabelStyle& style, const WordRoom& words = {});
  /// Returns `textOf(…).box` for widths up to `WordRoom::part`, apart from kerning of spaces.
  glm::vec2 boxAt(float widestMm) const;

 private:
  /// Widths of a word's part, as `textOf` divides the word if the whole is too wide. Pixels of the
  /// font.
  struct PartWidths {
    float width = 0.0f;
    float hyphen = 0.0f;  ///< added at a line's end
  };
  struct WordWidths {
    float whole = 0.0f;
    std::vector<PartWidths> parts;
  };
  struct ParagraphWidths {
    std::vector<WordWidths> words;
    float indent = 0.0f;  ///< that of a list item
  };
  struct Filled {
    std::size_t lines = 0;
    float width = 0.0f;  ///< that of the widest line
  };
  /// Fills lines no wider than `most`, with words divided that are wider than `widest`.
  Filled fill(float widest, float most) const;

  std::vector<ParagraphWidths> m_paragraphs;
  std::optional<glm::vec2> m_fixed;  ///< the box of a text that is never broken
  glm::vec2 m_padding{0.0f};
  float m_space = 0.0f;
  float m_scale = 1.0f;  ///< millimetres per pixel of the font
  float m_lineHeight = 0.0f;
};

}  // namespace sline::render
