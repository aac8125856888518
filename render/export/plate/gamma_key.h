// SPDX-License-Identifier: Apache-2.0
// Explains pictures in which Γ varies over surfaces: by what, from where to where, and how the
// drawing changes along it.
#pragma once

#include <vector>

#include "render/export/order/export_order.h"
#include "render/lettering/lettering.h"
#include "render/lettering/mark_words.h"

namespace sline::render {

/// Holds what a map of Γ is told by.
struct GammaKey {
  model::ResolvedStyle style;  ///< of the first structure that has the map
  QString title;               ///< "Distance from liver (mm)"; names few of several
  QString fullTitle;           ///< names all
  Limits<float> range;         ///< of the scalar, as far as the drawing changes
  bool alone = true;           ///< no other structure has it, so that its colour is the structure's
};

/// Returns a key for each way in which Γ of visible structures varies, in the order of the scene.
std::vector<GammaKey> gammaKeys(const ExportOrder& order, const MarkWords& words);

/// How a key is drawn.
struct GammaKeyStyle {
  float points = 8.0f;  ///< of its letters
  float width = 48.0f;  ///< millimetres that it may take
  LetteringColours colours;
};
inline constexpr int gammaSwatches = 6;
/// Returns the size of a key, millimetres.
glm::vec2 gammaKeySize(const GammaKey& key, const GammaKeyStyle& style);
/// Returns the key with its upper left corner there: its title, a strip of small bodies drawn as
/// structures are where the scalar has values from one end of the range to the other, and these
/// values.
std::vector<LetteringItem> drawnGammaKey(const GammaKey& key, const glm::vec2& corner,
                                         const GammaKeyStyle& style, const MarkWords& words);

}  // namespace sline::render
