// SPDX-License-Identifier: Apache-2.0
// The scene's annotations as a picture has them: which are shown, where their places are and
// whether something is before them.
#pragma once

#include <string>
#include <vector>

#include "render/labels/layout.h"
#include "render/labels/screen.h"
#include "render/labels/sight.h"

namespace sline::render {

struct ShownLabel {
  LabelItem item;    ///< whoever knows fonts gives it its box
  std::string text;  ///< in the language asked for, else the scene's own; a callout's with markers
  /// From 1, in the order of the scene's annotations, among all that are visible: the same from
  /// every side.
  int number = 0;
  std::optional<Colour> colour;
  std::optional<float> lengthMm;  ///< of a distance
};

/// Its text where styles cannot be.
std::string plainText(const ShownLabel& label);

/// In the order of the scene. Not shown is what is not visible (a scene that shows a saved view,
/// model/edit/views.h, says so as the view does), what is on a structure that is not drawn or on a
/// part that a section takes away, and what is not within the picture.
std::vector<ShownLabel> shownLabels(const model::Scene& scene, const Screen& screen,
                                    const std::string& language, model::MeshTrees& trees);

/// Visible annotations that are not among those, by the reason; in the order of the scene.
struct UnseenLabels {
  std::vector<model::AnnotationId> notDrawn;  ///< what they are on
  std::vector<model::AnnotationId> offPicture;
};
UnseenLabels unseenLabels(const model::Scene& scene, const Screen& screen, model::MeshTrees& trees);

}  // namespace sline::render
