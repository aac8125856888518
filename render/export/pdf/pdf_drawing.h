// SPDX-License-Identifier: Apache-2.0
// A drawing as a PDF page shows it: paths, with fills and groups of structures as clear as they
// are.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "render/labels/shapes.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Where on a page; millimetres from its upper left corner.
struct PdfPlace {
  glm::vec2 at{0.0f};  ///< of the drawing's upper left corner
  LabelBox clip;       ///< nothing is drawn beside it
};

/// A group of paths that is clear as a whole: an object of its own, drawn by its name.
struct PdfForm {
  std::string operators;
  LabelBox box;             ///< nothing is drawn beside it; in the units of what draws it
  std::set<int> opacities;  ///< as those of `PdfContent`
};

/// What a page's content says, and what it names.
struct PdfContent {
  std::string operators;
  std::set<int> opacities;     ///< percent; each has a state, called `pdfStateName`
  std::vector<PdfForm> forms;  ///< called `pdfFormName`
};

std::string pdfStateName(int percent);
std::string pdfFormName(std::size_t index);

/// Appends the drawing. No name of a structure is written. The page's height is in points.
void appendDrawing(PdfContent& content, const VectorDrawing& drawing, const PdfPlace& place,
                   double pageHeight);

inline constexpr double pointsPerMillimetre = 72.0 / 25.4;

}  // namespace sline::render
