// SPDX-License-Identifier: Apache-2.0
// Writes a page with several drawings and what is written over them, the same as SVG, PDF and
// picture.
#pragma once

#include <QImage>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/export/svg/svg_lettering.h"
#include "render/export/svg/svg_sheet.h"

namespace sline::render {

struct DrawnPage {
  glm::vec2 sizeMm{0.0f};
  std::vector<SvgFigure> drawings;   ///< each covers those before; they must outlive the page
  std::vector<SvgWriting> writings;  ///< above all drawings, each above those before
  std::string language = "en";       ///< BCP 47, for programs that read aloud
  ExportCredit credit;
};

/// The kinds of files that a page is written as: what names end in, that which is offered first.
inline constexpr std::array<std::string_view, 4> pageEndings{"pdf", "svg", "png", "tiff"};

/// How a page becomes pixels.
struct PagePixels {
  float dpi = 600.0f;
  bool inkAlone = false;  ///< each pixel is black or white, no grey at all
  int bits = 8;  ///< of a channel; 1 with `inkAlone` alone: black and white are single bits
};

/// Tells whether a page can be written under that name, whose ending is one of `pageEndings` or
/// "tif". `what` is how the error calls it: "a comparison sheet".
Status checkPageName(const std::filesystem::path& target, const std::string& what);

/// Returns the page as a picture so many pixels wide. It needs a QGuiApplication.
QImage pagePicture(const DrawnPage& page, int width);

/// Writes the page as its name's ending says: SVG and PDF with lines as lines and text as text, PNG
/// and TIFF in pixels, drawn in bands. Where the progress says so it stops with `givenUp`, and the
/// file is as it was before. It needs a QGuiApplication.
Status writePage(const DrawnPage& page, const std::filesystem::path& target,
                 const PagePixels& pixels, const ExportProgress& progress = {});

}  // namespace sline::render
