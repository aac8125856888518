// SPDX-License-Identifier: Apache-2.0
// Divides a slide into title, figure and text. Lengths are millimetres of the slide from its upper
// left corner.
#pragma once

#include "render/export/order/export_order.h"
#include "render/export/slides/slide_options.h"

namespace sline::render {

/// How much larger everything is on a slide than on the page of its figure: labels of 10 points are
/// 1/30 of the slide's height, as they are in films.
inline constexpr float slideScale = 1.8f;

struct SlideBox {
  glm::vec2 at{0.0f};
  glm::vec2 size{0.0f};
};

struct SlideFrames {
  SlideBox title;
  SlideBox figure;
  SlideBox text;  ///< beside the figure, or below it on slides that are less wide
  SlideBox list;  ///< all below the title, for slides without a figure
};

glm::vec2 slideSizeMm(SlideShape shape);
/// Returns the frames of slides with a text or without.
SlideFrames slideFrames(SlideShape shape, bool text);

/// Returns the saved view that the order shows, by its name; null if there is none.
const model::View* shownView(const ExportOrder& order);
/// Tells whether the view has a text to be read, in the order's language.
bool hasText(const model::View* view, const ExportOrder& order);
/// Returns the size of the figure's page for that view on a slide; null: for no view.
glm::vec2 slidePageMm(const ExportOrder& order, const model::View* view);
/// Returns it for what the order shows.
glm::vec2 slidePageMm(const ExportOrder& order);

/// Returns the order of the figure on a slide for that view, null for none: on its page, and
/// without what the slide says itself.
ExportOrder slideFigure(ExportOrder order, const model::View* view);

/// Returns the order of the figure on the slide of one of its scene's views.
ExportOrder slideOfView(const ExportOrder& order, const model::View& view);

/// Tells whether slides show the saved views, and not what the order shows.
bool showsViews(const ExportOrder& order);

}  // namespace sline::render
