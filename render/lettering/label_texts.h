// SPDX-License-Identifier: Apache-2.0
// Texts of labels broken into lines and measured.
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

/// How wide a word may be that has no place to be divided, and its parts where it is wider, each
/// with a hyphen where its script has them. Millimetres.
struct WordRoom {
  float whole = std::numeric_limits<float>::infinity();
  float part = std::numeric_limits<float>::infinity();
};

struct LabelText {
  std::vector<TextLine> lines;
  bool list = false;    ///< some are items: all begin at the same side, wherever the label stands
  glm::vec2 box{0.0f};  ///< millimetres, with padding
};

/// What a key says of the label: its words without markup, a distance's length behind them.
std::string keyText(const ShownLabel& label, const LabelStyle& style);

/// Of its runs one after the other, without its indent, in the font's pixels.
qreal advanceOf(const TextLine& line);
/// With its indent in that size, millimetres.
float textWidthMm(const TextLine& line, float points);
/// Of capitals, millimetres.
float capHeightMm(float points);

/// Around the text within its box, millimetres.
glm::vec2 paddingOf(model::AnnotationKind kind, const LabelStyle& style);
float lineHeightMm(const LabelStyle& style);
/// Of a blank line, the same for every text: its length gives nothing away.
float blankWidthMm(const LabelStyle& style);
/// A distance has its length, in the language's digits, behind its text. A callout's text is marked
/// up (model/scene/markup.h), and its lines begin where its writer began them, too. Lines are
/// broken between words so that none is wider than `widestMm`, and within words that are wider,
/// where their script or names that programs join allow it; elsewhere only where they are wider
/// than there is room for words. A text that no page has room for is cut short.
LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm,
                 const WordRoom& words = {});
/// No lines of labels are wider in a picture of that width, unless a word is.
float widestTextMm(float pictureWidthMm, const LabelStyle& style);
/// Of words in such a picture.
WordRoom wordRoom(float pictureWidthMm, const LabelStyle& style);

/// A label's words, measured once so that many widths can be tried.
class MeasuredText {
 public:
  MeasuredText(const ShownLabel& label, const LabelStyle& style, const WordRoom& words = {});
  /// `textOf(…).box`, but for what kerning makes of spaces; of widths up to `WordRoom::part`.
  glm::vec2 boxAt(float widestMm) const;

 private:
  /// A word's parts, as `textOf` divides it where the whole is too wide. Pixels of the font.
  struct PartWidths {
    float width = 0.0f;
    float hyphen = 0.0f;  ///< that it has besides at a line's end
  };
  struct WordWidths {
    float whole = 0.0f;
    std::vector<PartWidths> parts;
  };
  struct ParagraphWidths {
    std::vector<WordWidths> words;
    float indent = 0.0f;  ///< of an item of a list
  };
  struct Filled {
    std::size_t lines = 0;
    float width = 0.0f;  ///< of the widest line
  };
  /// Words that are wider than `widest` divided, in lines no wider than `most`.
  Filled fill(float widest, float most) const;

  std::vector<ParagraphWidths> m_paragraphs;
  std::optional<glm::vec2> m_fixed;  ///< the box of what is never broken
  glm::vec2 m_padding{0.0f};
  float m_space = 0.0f;
  float m_scale = 1.0f;  ///< millimetres to the font's pixel
  float m_lineHeight = 0.0f;
};

}  // namespace sline::render
