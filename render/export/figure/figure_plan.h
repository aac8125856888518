// SPDX-License-Identifier: Apache-2.0
// Makes an order of each panel of a figure: its scene as its view shows it, its camera, its own
// page, what is written in it. Nothing is drawn yet.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/figure/figure_layout.h"
#include "render/export/figure/figure_credits.h"
#include "render/export/figure/figure_legend.h"
#include "render/export/figure/figure_options.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// Scenes by their files' names as the figure gives them.
using FigureScenes = std::map<std::string, std::shared_ptr<const model::Scene>>;

/// An inset's frame on the page.
struct InsetFrame {
  std::size_t panel = 0;           ///< the inset
  std::size_t of = 0;              ///< the panel that it shows a part of
  std::vector<glm::vec2> corners;  ///< on the page, from the upper left one clockwise
  bool lines = false;
};

struct FigurePlan {
  model::Figure figure;
  model::FigureLayout layout;
  std::vector<ExportOrder> panels;  ///< on pages of their size
  std::vector<InsetFrame> frames;
  FigureLegendRows legend{LegendList::none, 0.0f};
  FigureCredits credits;  ///< below the legend
  /// The height that pens are measured by, the same for all panels; millimetres.
  float penHeightMm = 0.0f;
};

/// Plans the figure. Errors name the panel: a scene that is not there, a view that its scene lacks,
/// a place that it cannot have. The options (`figureOptions`) say whether the page tells whose work
/// the surfaces are. It needs a QGuiApplication.
Result<FigurePlan> planFigure(const model::Figure& figure, const FigureScenes& scenes,
                              const ExportOrder& options = usualFigureOrder());

/// Returns the room that the letter takes of its panel's upper left corner.
LabelBox letterBox(const model::Figure& figure, const std::string& letter);
/// Returns the letter as it stands in the panel at that corner.
LetteringItem drawnLetter(const model::Figure& figure, const std::string& letter,
                          const glm::vec2& corner);

}  // namespace sline::render
