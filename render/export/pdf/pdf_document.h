// SPDX-License-Identifier: Apache-2.0
// Joins pages that Qt has painted and drawings below them into a PDF file, with qpdf.
#pragma once

#include <QByteArray>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pdf/pdf_drawing.h"
#include "render/export/pdf/pdf_navigation.h"

namespace sline::render {

/// Describes the whole file.
struct PdfDescription {
  glm::dvec2 pageSize{0.0};  ///< of all pages, points
  std::string language;      ///< BCP 47, for programs that read aloud
  std::string title;         ///< shown above the pages by viewers; may be empty
  ExportCredit credit = {};
  PdfNavigation navigation = {};
};

/// Joins the painted pages, the upper edge of each at that of its page, with one drawing's content
/// below each. The file is linearised and the same for the same pages: nothing remains of what the
/// painted file says about its making (information, XMP, dates, identifiers). It fails for bytes
/// that are not a PDF or have another number of pages.
Result<QByteArray> joinedPdf(const QByteArray& painted, const std::vector<PdfContent>& below,
                             const PdfDescription& description);

}  // namespace sline::render
