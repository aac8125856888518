// SPDX-License-Identifier: Apache-2.0
// Follows each label through the frames of a film.
#pragma once

#include <vector>

#include "render/labels/layout.h"

namespace sline::render {

struct FilmLabel {
  model::AnnotationId id;
  std::vector<LabelItem*> items;  ///< of each frame; null where the label is not in the picture
  std::vector<bool> there;        ///< in which frames it stands

  /// Tells whether one sees in that frame what the label names.
  bool seen(std::size_t frame) const { return items[frame] && !items[frame]->hidden; }
};

/// Returns the labels of all frames, of which the requests must outlive them and stay where they
/// are. Each stands wherever it is in the picture.
std::vector<FilmLabel> filmLabels(std::vector<LabelRequest>& frames);

}  // namespace sline::render
