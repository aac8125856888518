// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/comparison_file.h"

#include <QByteArray>
#include <cmath>

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "render/export/encoding/png_image.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/picture_pages.h"
#include "render/export/svg/svg_sheet.h"

namespace sline::render {

namespace {

PdfPlacement placeOf(const SheetCell& cell) {
  return {.at = cell.at, .clip = {cell.at, cell.at + cell.drawing->sizeMm}};
}

Status writePdfSheet(const ComparisonSheet& sheet, const std::filesystem::path& target) {
  PdfPages pages(sheet.sizeMm, "en");
  for (const SheetCell& cell : sheet.cells)
    pages.place(*cell.drawing, placeOf(cell));
  paintLettering(pages.painter(), sheet.lettering, setText);
  const Result<QByteArray> document = pages.finish();
  if (!document.ok())
    return document.error();
  return model::writeText(target,
                          std::string_view(document->constData(), std::size_t(document->size())));
}

Status writePicture(const ComparisonSheet& sheet, const std::filesystem::path& target, float dpi) {
  const int width = int(std::lround(sheet.sizeMm.x / millimetresPerInch * dpi));
  if (width > pixelSideLimits.high ||
      sheet.sizeMm.y / sheet.sizeMm.x * float(width) > float(pixelSideLimits.high))
    return Error{.reason = "the sheet would have more than 20000 pixels on a side",
                 .remedy = "Take fewer pixels to the inch, smaller cells or fewer models"};
  PicturePages pages(sheet.sizeMm, std::max(width, pixelSideLimits.low));
  pages.painter().setRenderHint(QPainter::Antialiasing);
  for (const SheetCell& cell : sheet.cells)
    pages.place(*cell.drawing, placeOf(cell));
  paintLettering(pages.painter(), sheet.lettering);
  const QImage page = pages.finish().front().convertToFormat(QImage::Format_RGBA8888);
  Image image{.width = page.width(), .height = page.height(), .rgba = {}};
  for (int y = 0; y < page.height(); ++y)
    image.rgba.insert(image.rgba.end(), page.constScanLine(y),
                      page.constScanLine(y) + 4 * std::ptrdiff_t(page.width()));
  const Result<std::string> png = pngOf(image);
  return png.ok() ? model::writeText(target, *png) : Status(png.error());
}

Status writeSvgSheet(const ComparisonSheet& sheet, const std::filesystem::path& target) {
  std::vector<SvgFigure> figures;
  for (const SheetCell& cell : sheet.cells)
    figures.push_back({cell.id, cell.name, cell.drawing, cell.at});
  return model::writeText(target, svgSheet(sheet.sizeMm, figures, sheet.lettering));
}

}  // namespace

Status checkSheetName(const std::filesystem::path& target) {
  const std::string ending = lowerExtension(target);
  if (ending == ".png" || ending == ".pdf" || ending == ".svg")
    return Unit{};
  return Error{.file = target.string(),
               .reason = "a comparison sheet is a png, pdf or svg file",
               .remedy = "Give the file one of these endings"};
}

Status writeSheet(const ComparisonSheet& sheet, const std::filesystem::path& target, float dpi) {
  if (Status named = checkSheetName(target); !named.ok())
    return named;
  const std::string ending = lowerExtension(target);
  if (ending == ".svg")
    return writeSvgSheet(sheet, target);
  return ending == ".pdf" ? writePdfSheet(sheet, target) : writePicture(sheet, target, dpi);
}

}  // namespace sline::render
