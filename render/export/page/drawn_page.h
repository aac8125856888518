// SPDX-License-Identifier: Apache-2.0
// Writes a page with several drawings and what is written over them, the same as SVG, PDF and
// picture.
#pragma once

#include <QImage>
#include <filesystem>
#include <string>
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

/// Tells whether a page can be written under that name: png, pdf or svg. `what` is how the error
/// calls it: "a comparison sheet".
Status checkPageName(const std::filesystem::path& target, const std::string& what);

/// Returns the page as a picture so many pixels wide. It needs a QGuiApplication.
QImage pagePicture(const DrawnPage& page, int width);

/// Writes the page as its name's ending says: SVG and PDF with lines as lines and text as text, PNG
/// with so many pixels to the inch. It needs a QGuiApplication.
Status writePage(const DrawnPage& page, const std::filesystem::path& target, float dpi);

}  // namespace sline::render
