// SPDX-License-Identifier: Apache-2.0
// Texts of labels broken into lines and measured.
#pragma once

#include <QFont>
#include <QStringList>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/export/order/label_style.h"
#include "render/labels/anchors.h"

namespace sline::render {

/// The font of labels, `labelFontPixels` high: the same on every machine. Needs a QGuiApplication.
inline constexpr int labelFontPixels = 100;
QFont labelFont();

struct LabelText {
  QStringList lines;    ///< plain text
  glm::vec2 box{0.0f};  ///< millimetres, with padding
};

/// Of that text in that size, millimetres.
float textWidthMm(const QString& text, float points);
/// Of capitals, millimetres.
float capHeightMm(float points);

/// Around the text within its box, millimetres.
glm::vec2 paddingOf(model::AnnotationKind kind, const LabelStyle& style);
float lineHeightMm(const LabelStyle& style);
/// Of a blank line, the same for every text: its length gives nothing away.
float blankWidthMm(const LabelStyle& style);
/// A distance has its length, in the language's digits, behind its text. Lines are broken between
/// words so that none is wider than `widestMm`, unless a word is; a callout's also where its text
/// has them.
LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm);
/// No lines of labels are wider, unless a word is.
float widestTextMm(float pictureWidthMm, const LabelStyle& style);

/// A label's words, measured once so that many widths can be tried.
class MeasuredText {
 public:
  MeasuredText(const ShownLabel& label, const LabelStyle& style);
  /// `textOf(…).box`, but for what kerning makes of spaces.
  glm::vec2 boxAt(float widestMm) const;

 private:
  /// A word's parts, as `textOf` divides it where the whole is too wide. Pixels of the font.
  struct Word {
    float whole = 0.0f;
    std::vector<float> parts;
  };
  using Paragraph = std::vector<Word>;

  std::vector<Paragraph> m_paragraphs;
  std::optional<glm::vec2> m_fixed;  ///< the box of what is never broken
  glm::vec2 m_padding{0.0f};
  float m_space = 0.0f;
  float m_scale = 1.0f;  ///< millimetres to the font's pixel
  float m_lineHeight = 0.0f;
};

}  // namespace sline::render
