// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/page_bands.h"

#include <algorithm>
#include <future>
#include <optional>

#include "render/export/pixels/page_overlay.h"
#include "render/export/pixels/pixel_options.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

/// Collects pieces into bands and passes these on; one is written while the next is drawn.
class BandWriter {
 public:
  BandWriter(const PageBands& bands, int bandRows, const PageOverlay& overlay, const BandTake& take)
      : m_bands(bands), m_bandRows(bandRows), m_overlay(overlay), m_take(take) {
    begin();
  }
  BandWriter(const BandWriter&) = delete;
  BandWriter& operator=(const BandWriter&) = delete;

  /// Adds a piece; returns false where the band before could not be written.
  bool add(const PicturePiece& piece) {
    putAverages(piece, m_bands.samples, m_top, m_rows);
    m_filled += std::size_t(piece.width) * std::size_t(piece.height);
    const std::size_t samples = std::size_t(m_bands.samples) * std::size_t(m_bands.samples);
    if (m_filled < samples * std::size_t(m_rows.width) * std::size_t(m_rows.height))
      return true;
    if (!wait().ok())
      return false;
    m_writing = std::async(std::launch::async,
                           [this, rows = std::move(m_rows), top = m_top]() mutable -> Status {
                             m_overlay.paint(rows, top);
                             return m_take(std::move(rows));
                           });
    m_top += m_bandRows;
    begin();
    return true;
  }

  Status wait() {
    if (m_writing.valid())
      m_written = m_writing.get();
    return m_written;
  }

  /// Returns the share of all rows.
  double share() const {
    const double rows = double(m_top) + double(m_filled) / double(m_bands.size.x) /
                                            double(m_bands.samples * m_bands.samples);
    return std::min(rows / double(m_bands.size.y), 1.0);
  }

 private:
  void begin() {
    m_filled = 0;
    m_rows.width = m_bands.size.x;
    m_rows.height = std::max(std::min(m_bandRows, m_bands.size.y - m_top), 0);
    m_rows.rgba.assign(std::size_t(m_rows.width) * std::size_t(m_rows.height) * 4, 0);
  }

  const PageBands& m_bands;
  int m_bandRows;
  const PageOverlay& m_overlay;
  const BandTake& m_take;
  int m_top = 0;
  PixelRows m_rows;
  std::size_t m_filled = 0;  ///< samples put into the band so far
  Status m_written = Unit{};
  std::future<Status> m_writing;
};

PictureSettings settingsOf(const ExportOrder& order, const PageBands& bands) {
  return {.width = bands.samples * bands.size.x,
          .height = bands.samples * bands.size.y,
          .environment = order.environment};
}

}  // namespace

Status drawBands(const ExportOrder& order, const PageBands& bands, const BandTake& take,
                 const ExportProgress& progress) {
  bool wanted = true;
  const auto tell = [&](double share, std::string_view what) {
    wanted = wanted && (!progress || progress(share, what));
    return wanted;
  };
  if (!tell(0.0, "preparing surfaces"))
    return givenUp({});
  const auto overlay = TRY(PageOverlay::create(order, bands.size));
  progress.note(overlay->notes());
  const Result<HeadlessPicture> picture = HeadlessPicture::create({.deep = bands.deep});
  if (!picture.ok())
    return bands.deep
               ? Error{.reason = "16 bits per channel need OpenGL: " + picture.error().reason,
                       .remedy = "Take 8 bits. " + picture.error().remedy}
               : picture.error();
  const PictureSettings settings = settingsOf(order, bands);
  (*picture)->prepare(order.scene, order.camera, settings);
  if (!tell(0.05, "drawing"))
    return givenUp({});

  const int rows = std::clamp(bands.bandSamples / settings.width / bands.samples, 1, bands.size.y);
  BandWriter writer(bands, rows, *overlay, take);
  const Result<bool> drawn = (*picture)->renderPieces(
      order.scene, order.camera, settings,
      {.bandRows = rows * bands.samples, .grid = bands.samples, .take = [&](PicturePiece&& piece) {
         return writer.add(piece) && tell(0.05 + 0.9 * writer.share(), "drawing");
       }});
  TRY(writer.wait());
  if (!drawn.ok())
    return drawn.error();
  return wanted ? Status(Unit{}) : Status(givenUp({}));
}

int usualSamples(glm::ivec2 size, const ExportOrder& order) {
  const auto& pixels = order.of<PixelOptions>();
  constexpr int mostPixels = 65535;  // of a picture's side, samples included
  const int most = std::max(mostPixels / std::max(size.x, size.y), 1);
  if (pixels.samples > 0)
    return std::min(pixels.samples, most);
  const double count = double(size.x) * double(size.y);
  const bool fine = order.pureInk || pixels.bits != 8;
  const int wanted = count <= 12.0e6 ? (fine ? 4 : 2) : (fine || count <= 40.0e6 ? 2 : 1);
  return std::min(wanted, most);
}

}  // namespace sline::render
