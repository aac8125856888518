// SPDX-License-Identifier: Apache-2.0
// A PDF file made of pages that Qt has painted and of drawings below them, with qpdf.
#pragma once

#include <QByteArray>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pdf/pdf_drawing.h"

namespace sline::render {

/// What is true of the whole file.
struct PdfDescription {
  glm::dvec2 pageSize{0.0};  ///< of all pages, points
  std::string language;      ///< BCP 47, for those who read aloud
  std::string title;         ///< that viewers show above the pages; may be empty
  ExportCredit credit = {};
};

/// The painted pages, the upper edge of each at that of its page, with one drawing's content below
/// each. The file is linearised and the same for the same pages: of what the painted one says of
/// its making (information, XMP, dates, identifiers) nothing is left. Fails for bytes that are no
/// PDF or have another number of pages.
Result<QByteArray> joinedPdf(const QByteArray& painted, const std::vector<PdfContent>& below,
                             const PdfDescription& description);

}  // namespace sline::render
