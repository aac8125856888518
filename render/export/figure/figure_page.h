// SPDX-License-Identifier: Apache-2.0
// Draws the panels of a figure and puts them on its page.
#pragma once

#include <vector>

#include "render/export/figure/figure_plan.h"
#include "render/export/page/drawn_page.h"
#include "render/export/plate/figure_plate.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

struct ComposedPanel {
  VectorDrawing drawing;
  FigurePlate plate;  ///< in millimetres from the panel's own corner, with what it lacks
};

struct ComposedFigure {
  FigurePlan plan;
  std::vector<ComposedPanel> panels;
  Lettering frames;   ///< of insets, and the lines that join them; on the page
  Lettering writing;  ///< letters and the legend; on the page
};

/// Draws the figure. Errors name the panel; it stops with `givenUp` where the progress says so. A
/// panel that `before` shows the same is taken from there.
Result<ComposedFigure> composeFigure(const FigurePlan& plan, const ExportProgress& progress,
                                     const ComposedFigure* before = nullptr);

/// Returns the page, which refers to the figure.
DrawnPage pageOf(const ComposedFigure& figure, const ExportCredit& credit = {});

/// Returns who made the figure, what it shows and, where its page says it, whose work it is of.
/// What is not said of what it shows is that of its panels one by one.
ExportCredit creditOf(const ComposedFigure& figure, const ExportOrder& options);

/// Writes the figure as its name's ending says; see `writePage`.
Status writeFigure(const ComposedFigure& figure, const ExportOrder& options,
                   const std::filesystem::path& target, const ExportProgress& progress);

}  // namespace sline::render
