// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/assembled.h"

#include <utility>

#include "model/scene/visible_structures.h"
#include "render/export/motion/film_options.h"
#include "render/export/order/ink_alone.h"
#include "render/export/pdf/lesson.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/plate_image.h"
#include "render/export/slides/slide_page.h"
#include "render/lettering/typesetting.h"

namespace sline::render {

namespace {

bool wantsViews(const ExportOrder& order, const ExportFormat& format) {
  return meansAllViews(order.of<ViewsOptions>().subject, format);
}

/// Gives the order what all files of the kind have, whatever they show.
void takeKind(ExportOrder& order, const ExportFormat& format) {
  if (format.has(viewsOption))
    order.of<ViewsOptions>().subject =
        wantsViews(order, format) ? ViewSubject::all : ViewSubject::shown;
  if (order.pureInk)
    order.environment.background = Background::white;
  order.labels.ground = order.environment.background;
}

/// Gives an order of one view, or of what is shown, the page of its kind.
void takePage(ExportOrder& order, const ExportFormat& format) {
  if (format.page == PageUse::shape)
    order.page.sizeMm = filmPageMm(order);
  else if (format.page == PageUse::slides)
    order = slideFigure(order, shownView(order));
  else if (isOnPaper(order, format) && !isLesson(order, format))
    order.page.sizeMm = sheetFigureMm(order);
}

Status frame(ExportOrder& order, const Framing& framing) {
  if (!framing)
    return Unit{};
  order.camera = TRY(framing(order));
  return Unit{};
}

}  // namespace

bool meansAllViews(ViewSubject subject, const ExportFormat& format) {
  const bool asKind = subject == ViewSubject::asKind && format.page == PageUse::slides;
  return format.has(viewsOption) && (asKind || subject == ViewSubject::all);
}

bool isLesson(const ExportOrder& order, const ExportFormat& format) {
  return format.holdsViews() && wantsViews(order, format) && !order.scene.views().empty();
}

bool isOnPaper(const ExportOrder& order, const ExportFormat& format) {
  return format.has(sheetOption) && (hasSheet(order) || wantsViews(order, format));
}

bool hasOwnPage(const ExportOrder& order, const ExportFormat& format) {
  return isOnPaper(order, format) || format.page == PageUse::slides ||
         (format.page == PageUse::shape && order.of<FilmOptions>().format != FilmFormat::page);
}

Result<std::vector<ExportPiece>> assembled(const ExportWish& wish, const ExportFormat& format) {
  ExportOrder whole = wish.order;
  takeKind(whole, format);
  const std::vector<model::View>& views = whole.scene.views();
  if (wantsViews(whole, format) && !format.holdsViews() && !views.empty()) {
    const auto targets = viewTargets(wish.target, views, format.extension);
    std::vector<ExportPiece> pieces;
    for (std::size_t i = 0; i < views.size(); ++i)
      pieces.push_back({pictureOfView(whole, views[i]), wish.filled, targets[i]});
    return pieces;
  }
  takePage(whole, format);
  if (whole.pureInk)
    leaveInkAlone(whole);
  if (format.page != PageUse::none)
    TRY(frame(whole, wish.framing));
  return std::vector<ExportPiece>{{std::move(whole), wish.filled, wish.target}};
}

Result<ExportOrder> assembledPicture(const ExportWish& wish) {
  ExportOrder order = wish.order;
  if (order.pureInk)
    leaveInkAlone(order);
  TRY(frame(order, wish.framing));
  return order;
}

std::vector<ExportOrder> pagesOf(const ExportOrder& order, const ExportFormat& format) {
  if (!isLesson(order, format))
    return {order};
  std::vector<ExportOrder> pages;
  for (const model::View& view : order.scene.views()) {
    if (isOnPaper(order, format))
      pages.push_back(lessonSheet(order, view));
    else if (format.page == PageUse::slides)
      pages.push_back(slideOfView(order, view));
    else
      pages.push_back(pictureOfView(order, view));
    pages.back().of<ViewsOptions>().subject = ViewSubject::shown;
  }
  return pages;
}

ExportOrder readyOrder(const ExportPiece& piece) {
  ExportOrder order = piece.order;
  if (!piece.filled)
    return order;
  const auto typesetting = Typesetting::create();
  const model::FreeSides sides =
      typesetting.ok() ? sidesOfPlate(sheetFigure(order), **typesetting) : model::FreeSides();
  order.camera = model::fittedToVisible(order.scene, order.camera,
                                        order.page.sizeMm.x / order.page.sizeMm.y, sides);
  return order;
}

}  // namespace sline::render
