// SPDX-License-Identifier: Apache-2.0
// Finds the scene's annotations as a picture has them: which are shown, where their places are and
// whether something is in front of them.
#pragma once

#include <string>
#include <vector>

#include "render/labels/layout.h"
#include "render/labels/screen.h"
#include "render/labels/sight.h"

namespace sline::render {

struct ShownLabel {
  LabelItem item;    ///< its box is set by code that knows fonts
  std::string text;  ///< in the language asked for, else the scene's own; a callout's with markup
  /// Counts from 1, in the order of the scene's annotations, among all that are visible: the same
  /// from every side.
  int number = 0;
  std::optional<Colour> colour;
  std::optional<float> lengthMm;  ///< of a distance
};

/// Returns the label's text for places where it cannot have styles.
std::string plainText(const ShownLabel& label);

/// Returns the shown labels in the order of the scene. An annotation is not shown if it is not
/// visible (in a scene that shows a saved view, model/edit/views.h, the view decides), if it is on
/// a structure that is not drawn or on a part that a section takes away, or if it is outside the
/// picture.
std::vector<ShownLabel> shownLabels(const model::Scene& scene, const Screen& screen,
                                    const std::string& language, model::MeshTrees& trees);

/// Holds visible annotations that are not among the shown labels, by the reason; in the order of
/// the scene.
struct UnseenLabels {
  std::vector<model::AnnotationId> notDrawn;  ///< their structure is not drawn
  std::vector<model::AnnotationId> offPicture;
};
UnseenLabels unseenLabels(const model::Scene& scene, const Screen& screen, model::MeshTrees& trees);

}  // namespace sline::render
