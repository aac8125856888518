// SPDX-License-Identifier: Apache-2.0
#include "render/export/page/drawn_page.h"

#include <QByteArray>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/picture_pages.h"
#include "render/export/pixels/image_file.h"
#include "render/lettering/lettering.h"

namespace sline::render {

namespace {

/// Puts all of it on a page of any kind; without `setText` letters are outlines. `goOn(share)` is
/// asked before each part and ends it where it returns false.
bool setPage(const DrawnPage& page, SheetPages& pages, const TextSetter& setText,
             const std::function<bool(double)>& goOn) {
  const auto count = double(page.drawings.size() + 1);
  double done = 0.0;
  for (const SvgFigure& figure : page.drawings) {
    if (!goOn(done++ / count))
      return false;
    pages.place(*figure.drawing,
                {.at = figure.at, .clip = {figure.at, figure.at + figure.drawing->sizeMm}});
  }
  if (!goOn(done / count))
    return false;
  for (const SvgWriting& writing : page.writings) {
    QPainter& painter = pages.painter();
    if (writing.halos)
      pages.leaveGaps(writing.lettering, writing.at);
    painter.save();
    painter.translate(qreal(writing.at.x), qreal(writing.at.y));
    paintLettering(painter, writing.lettering, setText);
    painter.restore();
  }
  return true;
}

bool always(double) {
  return true;
}

/// A part of a page's picture, from some row on.
class BandPage : public SheetPages {
 public:
  BandPage(double pixelsPerMm, int top, const QSize& size) : m_image(size, QImage::Format_RGB32) {
    m_image.fill(Qt::white);
    m_painter = std::make_unique<QPainter>(&m_image);
    m_painter->setRenderHint(QPainter::Antialiasing);
    m_painter->translate(0.0, -qreal(top));
    m_painter->scale(pixelsPerMm, pixelsPerMm);
  }

  void newPage() override {}
  QPainter& painter() override { return *m_painter; }
  void place(const VectorDrawing& drawing, const PdfPlacement& place) override {
    paintDrawing(*m_painter, drawing, place);
  }
  QImage finish() {
    m_painter.reset();
    return std::move(m_image);
  }

 private:
  QImage m_image;
  std::unique_ptr<QPainter> m_painter;
};

/// Returns the picture's rows as the layout has them, on white.
std::vector<std::byte> packedRows(const QImage& band, const PixelLayout& layout) {
  std::vector<std::byte> bytes(layout.rowBytes() * std::size_t(band.height()));
  if (layout.channels == 3) {
    const QImage colours = band.convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < band.height(); ++y)
      std::copy_n(std::as_bytes(std::span(colours.constScanLine(y), layout.rowBytes())).begin(),
                  layout.rowBytes(), bytes.begin() + std::ptrdiff_t(y) * layout.rowBytes());
    return bytes;
  }
  constexpr std::uint8_t half = 128;  // a pixel half covered by ink is ink
  const QImage greys = band.convertToFormat(QImage::Format_Grayscale8);
  for (int y = 0; y < band.height(); ++y) {
    const std::uint8_t* from = greys.constScanLine(y);
    std::byte* to = bytes.data() + std::size_t(y) * layout.rowBytes();
    for (int x = 0; x < band.width(); ++x)
      if (from[x] >= half) {
        if (layout.bits == 1)
          to[x / 8] |= std::byte(0x80 >> (x % 8));
        else
          to[x] = std::byte(0xff);
      }
  }
  return bytes;
}

Result<PixelLayout> layoutOf(const DrawnPage& page, const PagePixels& pixels) {
  const double perMm = double(pixels.dpi) / double(millimetresPerInch);
  const int width = std::max(int(std::lround(double(page.sizeMm.x) * perMm)), pixelSideLimits.low);
  const int height =
      int(std::lround(double(page.sizeMm.y) / double(page.sizeMm.x) * double(width)));
  if (std::max(width, height) > pixelSideLimits.high)
    return Error{.reason = "the sheet would have more than 20000 pixels on a side",
                 .remedy = "Take fewer pixels to the inch, or a smaller sheet"};
  return PixelLayout{.width = width,
                     .height = std::max(height, 1),
                     .channels = pixels.inkAlone ? 1 : 3,
                     .bits = pixels.inkAlone ? pixels.bits : 8,
                     .dpi = pixels.dpi,
                     .credit = page.credit};
}

Status writePixelPage(const DrawnPage& page, const std::filesystem::path& target,
                      const PagePixels& pixels, const ExportProgress& progress) {
  const PixelLayout layout = TRY(layoutOf(page, pixels));
  constexpr int bandPixels = 4'000'000;
  const int most = std::clamp(bandPixels / layout.width, 1, layout.height);
  const double perMm = double(layout.width) / double(page.sizeMm.x);
  const PixelKind kind = lowerExtension(target) == ".png" ? PixelKind::png : PixelKind::tiff;
  return model::writeBeside(target, [&](const std::filesystem::path& beside) -> Status {
    const std::unique_ptr<RowFile> file = TRY(rowFile(kind, layout, beside));
    for (int top = 0; top < layout.height; top += most) {
      BandPage band(perMm, top, {layout.width, std::min(most, layout.height - top)});
      const auto goOn = [&](double share) {
        const double rows = double(top) + share * double(most);
        return !progress || progress(std::min(1.0, rows / double(layout.height)), "writing");
      };
      if (!setPage(page, band, {}, goOn))
        return givenUp(target);
      TRY(file->add(packedRows(band.finish(), layout)));
    }
    return file->finish();
  });
}

Status writePdfPage(const DrawnPage& page, const std::filesystem::path& target,
                    const std::function<bool(double)>& goOn) {
  PdfPages pages(page.sizeMm, page.language);
  if (!setPage(page, pages, setText, goOn))
    return givenUp(target);
  pages.describe({page.credit.description, page.credit.descriptionLanguage});
  ExportCredit credit = page.credit;
  credit.description.clear();  // it is said of the page
  const QByteArray document = TRY(pages.finish(credit));
  if (!goOn(1.0))
    return givenUp(target);
  return model::writeText(target,
                          std::string_view(document.constData(), std::size_t(document.size())));
}

Status writeSvgPage(const DrawnPage& page, const std::filesystem::path& target,
                    const std::function<bool(double)>& goOn) {
  if (!goOn(0.0))
    return givenUp(target);
  const std::string text = svgSheet(page.sizeMm, page.drawings, page.writings, page.credit);
  return goOn(1.0) ? model::writeText(target, text) : Status(givenUp(target));
}

}  // namespace

Status checkPageName(const std::filesystem::path& target, const std::string& what) {
  const std::string ending = lowerExtension(target);
  for (const std::string_view known : pageEndings)
    if (ending == "." + std::string(known) || ending == ".tif")
      return Unit{};
  return Error{.file = target.string(),
               .reason = what + " is a pdf, svg, png or tiff file",
               .remedy = "Give the file one of these endings"};
}

QImage pagePicture(const DrawnPage& page, int width) {
  PicturePages pages(page.sizeMm, width);
  pages.painter().setRenderHint(QPainter::Antialiasing);
  setPage(page, pages, {}, always);
  return pages.finish().front();
}

Status writePage(const DrawnPage& page, const std::filesystem::path& target,
                 const PagePixels& pixels, const ExportProgress& progress) {
  TRY(checkPageName(target, "a page"));
  const auto goOn = [&progress](double share) { return !progress || progress(share, "writing"); };
  const std::string ending = lowerExtension(target);
  if (ending == ".svg")
    return writeSvgPage(page, target, goOn);
  return ending == ".pdf" ? writePdfPage(page, target, goOn)
                          : writePixelPage(page, target, pixels, progress);
}

}  // namespace sline::render
