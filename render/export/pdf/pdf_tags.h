// SPDX-License-Identifier: Apache-2.0
// Tags a PDF file (ISO 32000-1, 14.8), so that programs that read aloud know of each page what its
// drawing shows and which text stands on it.
#pragma once

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <string>
#include <vector>

#include "render/export/pdf/pdf_drawing.h"

namespace sline::render {

/// Returns the operators of a page's drawing as its figure; where nothing is said of it, as what
/// programs that read aloud pass over.
std::string taggedDrawing(const PdfContent& content);

/// Marks each text of a page that Qt has painted as one of its own, and all else of it as what is
/// passed over; returns how many texts there are. To be called before the drawing is put below.
int tagTexts(QPDF& file, QPDFPageObjectHelper& page);

/// Adds the tree of the document: a section for each page, with its figure, where the page's
/// content says what that shows, and with its texts, of which there are so many. Contents must be
/// marked as above.
void addTags(QPDF& file, std::vector<QPDFPageObjectHelper>& pages,
             const std::vector<PdfContent>& contents, const std::vector<int>& texts);

}  // namespace sline::render
