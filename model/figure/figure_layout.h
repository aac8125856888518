// SPDX-License-Identifier: Apache-2.0
// Lays the panels of a figure out on its page.
#pragma once

#include <vector>

#include "model/base/result.h"
#include "model/figure/figure.h"

namespace sline::model {

struct PlacedPanel {
  FigureBox box;       ///< on the page
  std::string letter;  ///< as shown; empty: none
  /// The panel whose camera this one has, or of which it shows a part.
  std::optional<std::size_t> from;
};

struct FigureLayout {
  glm::vec2 sizeMm{0.0f};
  std::vector<PlacedPanel> panels;
  std::vector<std::size_t> order;  ///< of the panels, each after the one that it follows
  FigureBox legend;                ///< the room for it at the foot, as high as was asked for
};

/// Lays the figure out with so much room for its legend at the foot. Errors name the panel.
Result<FigureLayout> layOut(const Figure& figure, float legendMm = 0.0f);

/// Checks all that can be told without scenes: letters, links, places.
Status checkFigure(const Figure& figure);

}  // namespace sline::model
