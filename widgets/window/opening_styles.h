// SPDX-License-Identifier: Apache-2.0
// Says in which drawing style what is opened appears: one preference, which the start page offers,
// too.
#pragma once

#include "model/look/drawing_styles.h"
#include "widgets/preferences/preferences.h"

namespace sline::widgets {

class DrawingChoice;

/// Returns the style that the preferences have for scenes without a look; null where these stay
/// plain.
const model::DrawingStyle* openingStyle(const Preferences& preferences);

/// Sets the background that the style is made for. The plate goes with any, as most people have it
/// without having chosen it.
void prepareBackground(Preferences& preferences, const model::DrawingStyle& style);

/// Offers the styles on the start page; a choice there is the preference, and the other way round.
void offerOpeningStyles(DrawingChoice& choice, Preferences& preferences);

}  // namespace sline::widgets
