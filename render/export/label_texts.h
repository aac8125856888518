// SPDX-License-Identifier: Apache-2.0
// Texts of labels broken into lines and measured.
#pragma once

#include <QFont>
#include <glm/vec2.hpp>

#include "render/export/order/label_style.h"
#include "render/export/text_lines.h"
#include "render/labels/anchors.h"

namespace sline::render {

/// The font of labels, `labelFontPixels` high: the same on every machine. Needs a QGuiApplication.
inline constexpr int labelFontPixels = 100;
QFont labelFont(const model::LetterStyle& style = {});

struct LabelText {
  std::vector<TextLine> lines;
  bool list = false;    ///< some are items: all begin at the same side, wherever the label stands
  glm::vec2 box{0.0f};  ///< millimetres, with padding
};

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
/// broken between words so that none is wider than `widestMm`, unless a word is. A text that no
/// page has room for is cut short.
LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm);

}  // namespace sline::render
