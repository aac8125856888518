// SPDX-License-Identifier: Apache-2.0
// A drawing as a PDF page shows it: paths, with fills and groups of structures as clear as they
// are.
#pragma once

#include "render/export/pdf/pdf_objects.h"
#include "render/labels/shapes.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Where on a page; millimetres from its upper left corner.
struct PdfPlace {
  glm::vec2 at{0.0f};  ///< of the drawing's upper left corner
  LabelBox clip;       ///< nothing is drawn beside it
};

/// What a page's content says, and the names it uses.
struct PdfContent {
  QByteArray operators;
  QByteArray states;  ///< entries of /ExtGState
  QByteArray forms;   ///< entries of /XObject
};

/// Appends the drawing; groups that are clear as a whole become objects of their own. `scene` names
/// no structure in the file. The page's height is in points.
void appendDrawing(PdfContent& content, PdfObjects& objects, const VectorDrawing& drawing,
                   const PdfPlace& place, double pageHeight);

inline constexpr double pointsPerMillimetre = 72.0 / 25.4;

}  // namespace sline::render
