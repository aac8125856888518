// SPDX-License-Identifier: Apache-2.0
// Texts of labels broken into lines and measured.
#pragma once

#include <QFont>
#include <QStringList>
#include <glm/vec2.hpp>

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
/// words so that none is wider than `widestMm`, unless a word is.
LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm);

}  // namespace sline::render
