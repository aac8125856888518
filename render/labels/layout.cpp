// SPDX-License-Identifier: Apache-2.0
#include "render/labels/layout.h"

#include <algorithm>

#include "render/labels/layouter.h"

namespace sline::render {

const PlacedLabel* LabelLayout::find(model::AnnotationId id) const {
  const auto found = std::find_if(labels.begin(), labels.end(),
                                  [id](const PlacedLabel& label) { return label.id == id; });
  return found == labels.end() ? nullptr : &*found;
}

LabelLayout layOutLabels(const LabelRequest& request, const LabelLayout* before) {
  return Layouter(request, before).layOut();
}

}  // namespace sline::render
