// SPDX-License-Identifier: Apache-2.0
// Sets the text that a sheet gives a patient: paragraphs below the figure.
#pragma once

#include <QTextLayout>
#include <memory>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

inline constexpr float patientPoints = 12.0f;
/// The distance from one line to the next, millimetres.
inline constexpr float patientLeading = 1.45f * patientPoints * millimetresPerPoint;
inline constexpr float patientParagraphSpace = 0.5f * patientLeading;

/// Returns one layout for each line of the text, broken between words for a frame that is so many
/// millimetres wide, in the font's pixels; null for an empty line. It needs a QGuiApplication.
std::vector<std::unique_ptr<QTextLayout>> patientParagraphs(const std::string& text, float widthMm);

/// Returns the height of the whole text, millimetres.
float patientTextHeight(const std::string& text, float widthMm);

}  // namespace sline::render
