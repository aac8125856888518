// SPDX-License-Identifier: Apache-2.0
#include "render/labels/layout.h"

#include <algorithm>
#include <utility>

#include "render/labels/layouter.h"

namespace sline::render {

const PlacedLabel* LabelLayout::find(model::AnnotationId id) const {
  const auto found = std::find_if(labels.begin(), labels.end(),
                                  [id](const PlacedLabel& label) { return label.id == id; });
  return found == labels.end() ? nullptr : &*found;
}

LabelLayout resized(const LabelLayout& layout, const glm::vec2& from, const glm::vec2& to) {
  const float scale = to.y / from.y;
  const auto moved = [&](const glm::vec2& p) { return 0.5f * to + scale * (p - 0.5f * from); };
  LabelLayout resized = layout;
  for (PlacedLabel& label : resized.labels) {
    const glm::vec2 half = 0.5f * label.box.size();
    const glm::vec2 middle = moved(label.box.middle());
    label.box = {middle - half, middle + half};
    for (glm::vec2& p : label.leader)
      p = moved(p);
  }
  for (float& edge : resized.edges)
    edge = moved({edge, 0.0f}).x;
  // Lines are broken anew, and columns are as wide as these need.
  resized.widths = {};
  resized.textWidth = 0.0f;
  for (LabelLayout& unmoved : resized.unmoved)
    unmoved = sline::render::resized(unmoved, from, to);
  return resized;
}

std::vector<std::pair<std::size_t, std::size_t>> labelConflicts(const LabelRequest& request) {
  return Layouter(request, nullptr).conflicts();
}

LabelLayout layOutLabels(const LabelRequest& request, const LabelLayout* before) {
  const LabelLayout* was = before && !before->unmoved.empty() ? &before->unmoved.front() : before;
  LabelRequest unmoved = request;
  for (LabelItem& item : unmoved.items)
    item.offset.reset();
  LabelLayout home = Layouter(unmoved, was).layOut();
  if (std::none_of(request.items.begin(), request.items.end(),
                   [](const LabelItem& item) { return item.offset.has_value(); }))
    return home;
  LabelLayout layout = Layouter(request, before, &home).layOut();
  layout.unmoved.push_back(std::move(home));
  return layout;
}

}  // namespace sline::render
