// SPDX-License-Identifier: Apache-2.0
#include "render/export/page/drawn_page.h"

#include <QByteArray>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "render/export/encoding/row_file.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/picture_pages.h"
#include "render/lettering/lettering.h"

namespace sline::render {

namespace {

/// Puts all of it on a page of any kind; without `setText` letters are outlines.
void setPage(const DrawnPage& page, SheetPages& pages, const TextSetter& setText) {
  for (const SvgFigure& figure : page.drawings)
    pages.place(*figure.drawing,
                {.at = figure.at, .clip = {figure.at, figure.at + figure.drawing->sizeMm}});
  for (const SvgWriting& writing : page.writings) {
    QPainter& painter = pages.painter();
    painter.save();
    painter.translate(qreal(writing.at.x), qreal(writing.at.y));
    paintLettering(painter, writing.lettering, setText);
    painter.restore();
  }
}

Status writePdfPage(const DrawnPage& page, const std::filesystem::path& target) {
  PdfPages pages(page.sizeMm, page.language);
  setPage(page, pages, setText);
  const Result<QByteArray> document = pages.finish(page.credit);
  if (!document.ok())
    return document.error();
  return model::writeText(target,
                          std::string_view(document->constData(), std::size_t(document->size())));
}

Status writePngPage(const DrawnPage& page, const std::filesystem::path& target, float dpi) {
  const int width = int(std::lround(page.sizeMm.x / millimetresPerInch * dpi));
  if (width > pixelSideLimits.high ||
      page.sizeMm.y / page.sizeMm.x * float(width) > float(pixelSideLimits.high))
    return Error{.reason = "the sheet would have more than 20000 pixels on a side",
                 .remedy = "Take fewer pixels to the inch, or a smaller sheet"};
  const QImage picture = pagePicture(page, std::max(width, pixelSideLimits.low))
                             .convertToFormat(QImage::Format_RGB888);
  const PixelLayout layout{
      .width = picture.width(), .height = picture.height(), .dpi = dpi, .credit = page.credit};
  std::string bytes;
  const std::unique_ptr<RowFile> png = pngRows(layout, [&bytes](std::string_view more) -> Status {
    bytes += more;
    return Unit{};
  });
  for (int y = 0; y < picture.height(); ++y)
    if (Status added =
            png->add(std::as_bytes(std::span(picture.constScanLine(y), layout.rowBytes())));
        !added.ok())
      return added;
  if (Status finished = png->finish(); !finished.ok())
    return finished;
  return model::writeText(target, bytes);
}

}  // namespace

Status checkPageName(const std::filesystem::path& target, const std::string& what) {
  const std::string ending = lowerExtension(target);
  if (ending == ".png" || ending == ".pdf" || ending == ".svg")
    return Unit{};
  return Error{.file = target.string(),
               .reason = what + " is a png, pdf or svg file",
               .remedy = "Give the file one of these endings"};
}

QImage pagePicture(const DrawnPage& page, int width) {
  PicturePages pages(page.sizeMm, width);
  pages.painter().setRenderHint(QPainter::Antialiasing);
  setPage(page, pages, {});
  return pages.finish().front();
}

Status writePage(const DrawnPage& page, const std::filesystem::path& target, float dpi) {
  if (Status named = checkPageName(target, "a page"); !named.ok())
    return named;
  const std::string ending = lowerExtension(target);
  if (ending == ".svg")
    return model::writeText(target,
                            svgSheet(page.sizeMm, page.drawings, page.writings, page.credit));
  return ending == ".pdf" ? writePdfPage(page, target) : writePngPage(page, target, dpi);
}

}  // namespace sline::render
