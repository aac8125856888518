// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

#include "model/scene/markup.h"

namespace sline::render {

/// The font of labels is `labelFontPixels` high and the same on every machine. It needs a
/// QGuiApplication.
inline constexpr int labelFontPixels = 100;
QFont labelFont(const model::LetterStyle& style = {});

}  // namespace sline::render
