// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_page.h"

#include <algorithm>
#include <utility>

#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

constexpr float margin = 10.0f;
constexpr float gap = 6.0f;
constexpr float titleTop = 6.0f;
constexpr float titleHeight = 18.0f;
constexpr float bottomMargin = 5.0f;
constexpr float textWidth = 92.0f;   // beside the figure
constexpr float textHeight = 36.0f;  // below it

}  // namespace

glm::vec2 slideSizeMm(SlideShape shape) {
  // PowerPoint's own: 7.5 inches high, and 13 1/3 or 10 wide.
  return {
      shape == SlideShape::wide ? 40.0f / 3.0f * millimetresPerInch : 10.0f * millimetresPerInch,
      7.5f * millimetresPerInch};
}

SlideFrames slideFrames(SlideShape shape, bool text) {
  const glm::vec2 size = slideSizeMm(shape);
  SlideFrames frames;
  const float width = size.x - 2.0f * margin;
  const float top = titleTop + titleHeight + 2.0f;
  frames.title = {{margin, titleTop}, {width, titleHeight}};
  frames.list = {{margin, top}, {width, size.y - bottomMargin - top}};
  frames.figure = frames.list;
  if (!text)
    return frames;
  if (shape == SlideShape::wide) {
    frames.figure.size.x -= textWidth + gap;
    frames.text = {{size.x - margin - textWidth, top}, {textWidth, frames.list.size.y}};
  } else {
    frames.figure.size.y -= textHeight + 0.5f * gap;
    frames.text = {{margin, size.y - bottomMargin - textHeight}, {width, textHeight}};
  }
  return frames;
}

const model::View* shownView(const ExportOrder& order) {
  const auto& views = order.scene.views();
  const auto found = std::find_if(views.begin(), views.end(), [&order](const model::View& view) {
    return !order.viewName.empty() && view.name == order.viewName;
  });
  return found == views.end() ? nullptr : &*found;
}

bool hasText(const model::View* view, const ExportOrder& order) {
  return view &&
         !model::markedLines(view->words.text.in(model::firstLanguage(order.labels.language)))
              .empty();
}

glm::vec2 slidePageMm(const ExportOrder& order, const model::View* view) {
  return slideFrames(order.of<SlideOptions>().shape, hasText(view, order)).figure.size / slideScale;
}

glm::vec2 slidePageMm(const ExportOrder& order) {
  return slidePageMm(order, shownView(order));
}

ExportOrder slideFigure(ExportOrder order, const model::View* view) {
  order.page.sizeMm = slidePageMm(order, view);
  order.marks.viewName = false;  // it is the title
  order.words = {.description = std::move(order.words.description)};
  return order;
}

ExportOrder slideOfView(const ExportOrder& order, const model::View& view) {
  ExportOrder page = order;
  page.page.sizeMm = slidePageMm(order, &view);
  return slideFigure(pictureOfView(page, view), &view);
}

bool showsViews(const ExportOrder& order) {
  return order.of<ViewsOptions>().subject != ViewSubject::shown && !order.scene.views().empty();
}

}  // namespace sline::render
