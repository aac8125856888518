// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_files.h"

#include <algorithm>
#include <string>

#include "model/disk/whole_file.h"
#include "render/export/description/alt_text.h"
#include "render/export/pixels/image_file.h"
#include "render/export/pixels/page_bands.h"
#include "render/export/pixels/pixel_options.h"

namespace sline::render {

PixelLayout layoutOf(const ExportOrder& order, PixelKind kind, glm::ivec2 size) {
  const PixelOptions& pixels = order.of<PixelOptions>();
  PixelLayout layout{
      .width = size.x, .height = size.y, .dpi = order.page.dpi, .credit = order.credit};
  const PixelTraits traits = traitsOf(kind);
  const bool ink = isInkAlone(order, kind);
  const bool alpha = traits.alpha && !(ink && pixels.bits == 1) &&
                     order.environment.background == Background::transparent;
  layout.channels = ((pixels.grey && traits.grey) || ink ? 1 : 3) + (alpha ? 1 : 0);
  if (kind == PixelKind::exr)
    layout.bits = 32;
  else if (traits.ink)
    layout.bits = ink ? std::min(pixels.bits, 8) : pixels.bits;
  else if (traits.deep)
    layout.bits = std::max(pixels.bits, 8);
  return layout;
}

bool isInkAlone(const ExportOrder& order, PixelKind kind) {
  return traitsOf(kind).ink && (order.pureInk || order.of<PixelOptions>().bits == 1);
}

namespace {

Status checkOrder(PixelKind kind, const ExportOrder& order, glm::ivec2 size,
                  const std::filesystem::path& target) {
  const int bits = order.of<PixelOptions>().bits;
  const int largest = std::min(traitsOf(kind).largestSide, pixelSideLimits.high);
  if (std::max(size.x, size.y) > largest)
    return Error{.file = target.string(),
                 .reason = "a picture of " + std::to_string(size.x) + "×" + std::to_string(size.y) +
                           " pixels is too large",
                 .remedy = "Choose fewer dots per inch or a smaller page; a side may have " +
                           std::to_string(largest) + " pixels in this kind of file"};
  if (double(size.x) * double(size.y) > traitsOf(kind).mostPixels)
    return Error{.file = target.string(),
                 .reason = "a picture of " + std::to_string(size.x) + "×" + std::to_string(size.y) +
                           " pixels is too large for this kind of file",
                 .remedy =
                     "Choose fewer dots per inch or a smaller page, or PNG or TIFF; a "
                     "picture may have " +
                     std::to_string(int(traitsOf(kind).mostPixels * 1e-6)) +
                     " million pixels here"};
  if (bits != 1 && bits != 8 && bits != 16)
    return Error{.file = target.string(),
                 .reason = "no picture has " + std::to_string(bits) + " bits a channel",
                 .remedy = "Give 1, 8 or 16"};
  return Unit{};
}

Status writePixels(PixelKind kind, const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress) {
  const glm::ivec2 size = pixelsOf(order.page);
  TRY(checkOrder(kind, order, size, target));
  PixelLayout layout = layoutOf(order, kind, size);
  layout.credit = fileCredit(order);
  const bool ink = isInkAlone(order, kind);
  progress.note(pixelNotes(order, kind));
  const PageBands bands{
      .size = size, .samples = usualSamples(size, order), .deep = layout.bits > 8};
  return model::writeBeside(target, [&](const std::filesystem::path& beside) -> Status {
    const std::unique_ptr<RowFile> file = TRY(rowFile(kind, layout, beside));
    TRY(drawBands(
        order, bands, [&](PixelRows&& rows) { return file->add(packed(rows, layout, ink)); },
        progress));
    if (progress && !progress(0.97, "writing the file"))
      return givenUp(target);
    return file->finish();
  });
}

}  // namespace

ExportNotes pixelNotes(const ExportOrder& order, PixelKind kind) {
  const PixelLayout layout = layoutOf(order, kind, pixelsOf(order.page));
  ExportNotes notes;
  if (order.environment.background == Background::transparent && !layout.hasAlpha())
    addNote(notes, {.kind = ExportNote::Kind::standsOnWhite, .names = {}, .detail = {}});
  if (layout.bits < order.of<PixelOptions>().bits)
    addNote(notes, {.kind = ExportNote::Kind::depthNotKept,
                    .names = {},
                    .detail = std::to_string(order.of<PixelOptions>().bits)});
  return notes;
}

Status writePng(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress) {
  return writePixels(PixelKind::png, order, target, progress);
}

Status writeTiff(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress) {
  return writePixels(PixelKind::tiff, order, target, progress);
}

Status writeExr(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress) {
  return writePixels(PixelKind::exr, order, target, progress);
}

Status writeJpeg(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress) {
  return writePixels(PixelKind::jpeg, order, target, progress);
}

Status writeWebpPicture(const ExportOrder& order, const std::filesystem::path& target,
                        const ExportProgress& progress) {
  return writePixels(PixelKind::webp, order, target, progress);
}

Status writeJp2(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress) {
  return writePixels(PixelKind::jp2, order, target, progress);
}

}  // namespace sline::render
