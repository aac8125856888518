// SPDX-License-Identifier: Apache-2.0
// Finds the scene's annotations as a picture has them: which are shown, where their places are and
// whether something is in front of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/lengths/told_length.h"
#include "model/scene/known_frame.h"
#include "render/labels/layout.h"
#include "render/labels/seen/screen.h"
#include "render/labels/seen/sight.h"

namespace sline::render {

/// A place in a film's picture of those that a label has had in any.
struct PlaceChoice {
  std::size_t index = 0;  ///< in PlacePool
  glm::vec2 place{0.0f};
  bool seen = false;  ///< one sees there what the label names
};

/// The places that labels have been found in, in pictures of a film.
struct PooledPlaces {
  std::vector<model::Anchor> anchors;
  std::optional<model::Anchor> last;  ///< that of the picture before
};
using PlacePool = std::map<model::AnnotationId, PooledPlaces>;

struct ShownLabel {
  LabelItem item;    ///< its box is set by code that knows fonts
  std::string text;  ///< in the language asked for, else the scene's own; a callout's with markup
  /// Counts from 1, in the order of the scene's annotations, among all that are visible; badges are
  /// numbered in reading order (label_painter.h).
  int number = 0;
  std::optional<Colour> colour;
  std::optional<model::DrawnLength> length;              ///< of a distance
  std::vector<PlaceChoice> choices;                      ///< with a pool: places in this picture
  model::DrawnUnit unit = model::DrawnUnit::millimetre;  ///< of the distance
};

/// Returns the label's text for places where it cannot have styles.
std::string plainText(const ShownLabel& label);

/// Holds visible annotations that point at nothing one sees, by the reason; in the order of the
/// scene.
struct UnseenLabels {
  std::vector<model::AnnotationId> notDrawn;  ///< their structure is not drawn
  std::vector<model::AnnotationId> offPicture;
  std::vector<model::AnnotationId> hidden;  ///< shown, but their place is hidden in this picture
};

struct LabelsInPicture {
  std::vector<ShownLabel> shown;  ///< in the order of the scene
  UnseenLabels unseen;
};

/// Tells what a picture follows.
struct LabelsBefore {
  const LabelLayout* layout = nullptr;  ///< of the picture before
  /// The camera moves and must not be held up: places that were found stay on their surface, and
  /// where another structure comes before them they are hidden until the camera rests.
  bool hurried = false;
  /// Set in a film: the places that may be chosen for labels whose place is found. Where one sees
  /// none of them, one is added.
  PlacePool* pool = nullptr;
};

/// Finds the labels of a picture. An annotation is not shown if it is not visible (in a scene that
/// shows a saved view, model/edit/views.h, the view decides), if it is on a structure that is not
/// drawn or that sections take away, or if it is outside the picture. Labels, callouts and pins are
/// hidden where their structure is not what one sees (seen_map.h). A place that was found, not set
/// by hand, or that a section takes away, is found anew; one in the picture before is kept where it
/// is as good.
LabelsInPicture labelsInPicture(const model::Scene& scene, const Screen& screen,
                                const std::string& language, model::MeshTrees& trees,
                                const LabelsBefore& before = {});
/// Adds the best place in this picture for each label whose place is found.
void addPlaces(PlacePool& pool, const model::Scene& scene, const Screen& screen,
               model::MeshTrees& trees);
/// Returns its shown labels.
std::vector<ShownLabel> shownLabels(const model::Scene& scene, const Screen& screen,
                                    const std::string& language, model::MeshTrees& trees);

}  // namespace sline::render
