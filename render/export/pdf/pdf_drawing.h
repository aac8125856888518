// SPDX-License-Identifier: Apache-2.0
// Writes a drawing as a PDF page shows it: paths, and fills and groups of structures with their
// transparency.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/labels/seen/shapes.h"
#include "render/lettering/lettering.h"
#include "render/vectors/paper_tile.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// A place on a page, in millimetres from its upper left corner.
struct PdfPlacement {
  glm::vec2 at{0.0f};  ///< of the drawing's upper left corner
  LabelBox clip;       ///< nothing is drawn outside it
};

/// A group of paths that is transparent as a whole: an object of its own, drawn by its name.
struct PdfForm {
  std::string operators;
  LabelBox box;  ///< nothing is drawn outside it; in the units of the content that draws it
  std::set<int> opacities;  ///< as in `PdfContent`
  int paper = 0;            ///< percent: draws in the state named by `pdfPaperName`; 0: in none
};

/// The paper of a page: tiles that cover it from its upper left corner, as forms see it.
struct PdfPaper {
  PaperTile tile;
  glm::vec2 sizeMm{0.0f};
};

/// Holds a page's content and what it refers to.
struct PdfContent {
  std::string operators;
  std::set<int> opacities;         ///< percent; each has a state, named by `pdfStateName`
  std::vector<PdfForm> forms;      ///< named by `pdfFormName`
  std::vector<Image> images;       ///< with alpha; named by `pdfImageName`
  std::map<int, PdfPaper> papers;  ///< by percent, of forms that show paper
  /// Paints in black what the drawing is not to cover; empty: it covers all.
  std::string gaps;
  std::string said;      ///< what the drawing shows, in words; empty: it is passed over
  std::string language;  ///< of that, BCP 47; empty: the document's
};

std::string pdfStateName(int percent);
std::string pdfFormName(std::size_t index);
std::string pdfImageName(std::size_t index);
std::string pdfPaperName(int percent);

/// Appends the drawing; names of structures are not written. The page's height is in points.
void appendDrawing(PdfContent& content, const VectorDrawing& drawing, const PdfPlacement& place,
                   double pageHeight);

/// Returns operators that paint the lettering's halos in black, for `PdfContent::gaps`. `at` is its
/// upper left corner.
std::string gapsOf(const Lettering& lettering, const glm::vec2& at, double pageHeight);

inline constexpr double pointsPerMillimetre = 72.0 / 25.4;

}  // namespace sline::render
