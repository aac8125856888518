// SPDX-License-Identifier: Apache-2.0
// Lets readers of a PDF file go from page to page: links on pages, and bookmarks beside them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/labels/seen/shapes.h"

class QPDF;
class QPDFPageObjectHelper;

namespace sline::render {

struct PdfLink {
  std::size_t page = 0;  ///< counted from 0, like `target`
  LabelBox box;          ///< millimetres from the page's upper left corner
  std::size_t target = 0;
};

struct PdfBookmark {
  std::string title;
  std::size_t page = 0;
  bool inner = false;  ///< belongs to the last one before it that is not
};

struct PdfNavigation {
  std::vector<PdfLink> links;
  std::vector<PdfBookmark> bookmarks;
};

/// Adds links and bookmarks to the file with those pages, of that height in points. Throws what
/// qpdf throws.
void addNavigation(QPDF& file, std::vector<QPDFPageObjectHelper>& pages,
                   const PdfNavigation& navigation, double pageHeight);

}  // namespace sline::render
