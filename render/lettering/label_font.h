// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

#include "model/scene/markup.h"

namespace sline::render {

/// The font of labels, `labelFontPixels` high: the same on every machine. Needs a QGuiApplication.
inline constexpr int labelFontPixels = 100;
QFont labelFont(const model::LetterStyle& style = {});

}  // namespace sline::render
