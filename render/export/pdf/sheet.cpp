// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet.h"

#include <memory>

#include "model/scene/label_words.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/picture_pages.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pdf/sheet_pictures.h"
#include "render/export/pdf/sheet_setter.h"
#include "render/export/pdf/sources_page.h"

namespace sline::render {

namespace {

/// Sets the pages twice: to count them, and with their numbers.
template <class Begin>
std::invoke_result_t<Begin> pagesOf(SheetSetter& sheet, const Begin& begin) {
  PageCount count;
  sheet.setAll(*begin(), count);
  std::invoke_result_t<Begin> pages = begin();
  PageCount numbered{.page = 0, .total = count.page};
  sheet.setAll(*pages, numbered);
  return pages;
}

}  // namespace

Result<QByteArray> sheetDocument(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress) {
  if (const auto fault = model::cameraFault(order.camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  SheetSetter sheet(order);
  TRY(sheet.draw(target, progress));
  if (progress && !progress(0.9, "setting the pages"))
    return givenUp(target);
  const auto pages = pagesOf(sheet, [&] {
    return std::make_unique<PdfPages>(sheet.layout().paper,
                                      model::firstLanguage(order.labels.language));
  });
  progress.note(sheet.notes());
  return pages->finish(fileCredit(order, {}), order.of<SheetOptions>().title);
}

Result<std::vector<QImage>> sheetPictures(const ExportOrder& order, const QImage& figure, int width,
                                          ExportNotes* notes) {
  if (const auto fault = model::cameraFault(order.camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  const ExportProgress progress([](double, std::string_view) { return true; }, notes);
  SheetSetter sheet(order);
  TRY(sheet.take(figure, progress));
  const auto pages =
      pagesOf(sheet, [&] { return std::make_unique<PicturePages>(sheet.layout().paper, width); });
  progress.note(sheet.notes());
  return pages->finish();
}

Result<QByteArray> figureDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress) {
  const VectorDrawing drawing = TRY(drawFigure(order, target, progress));
  PdfPages pages(order.page.sizeMm, model::firstLanguage(order.labels.language));
  pages.place(drawing, {{}, {{}, order.page.sizeMm}});
  pages.describe(altTextOf(order));
  ExportOrder figure = order;
  withoutSourcesLine(figure);
  const FigurePlate plate = figurePlate(figure);
  progress.note(plate.notes);
  setPlate(pages, plate, {});
  setSourcesPage(pages, order);
  return pages.finish(fileCredit(order, {}));
}

}  // namespace sline::render
