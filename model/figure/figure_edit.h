// SPDX-License-Identifier: Apache-2.0
// Edits figures. Panels name each other by letters, which follow their order: what refers to a
// panel follows it to its new letter, and goes with it.
#pragma once

#include "model/figure/figure.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns a figure of the scene's saved views, as many as there are letters; of a scene without
/// any, of its front and its left side.
Figure figureOf(const Scene& scene, const std::string& file);

/// Returns the figure with the panel at its end; unchanged where it has as many as it can have.
Figure withPanel(const Figure& figure, const FigurePanel& panel);

/// Returns it without the panel: insets of it go, too, and cameras that were like its are their
/// own.
Figure withoutPanel(const Figure& figure, std::size_t index);

/// Returns it with the panel at index `to`.
Figure withPanelMoved(const Figure& figure, std::size_t index, std::size_t to);

/// Returns it with an inset at its end that shows that part of the panel.
Figure withInset(const Figure& figure, std::size_t of, const FigureBox& part);

/// Returns the place of an inset on a panel of that size: its upper right corner, of the part's
/// shape and as large as fits in a third of it; absent where that is too small.
std::optional<FigureBox> insetPlace(const FigureBox& part, const glm::vec2& panelMm);

/// Returns the panels whose cameras another one may be like without leading back to itself.
std::vector<std::size_t> camerasFor(const Figure& figure, std::size_t index);

}  // namespace sline::model
