// SPDX-License-Identifier: Apache-2.0
#include "render/labels/anchors.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "model/scene/label_words.h"
#include "model/scene/markup.h"

namespace sline::render {

namespace {

std::optional<LabelItem> itemOf(const model::Annotation& annotation, const model::Scene& scene,
                                const Screen& screen, const Sights& sights) {
  LabelItem item{.id = annotation.id, .kind = annotation.kind};
  for (const model::Anchor& anchor : annotation.anchors) {
    if (!sights.shows(anchor))
      return std::nullopt;
    const std::optional<glm::vec2> place = screen.place(*scene.placeOf(anchor));
    if (!place || !screen.inside(*place))
      return std::nullopt;
    item.places.push_back(*place);
    item.hidden = item.hidden || sights.hidden(anchor, screen.sight(*place));
  }
  if (annotation.offset)
    item.offset = screen.size().y * *annotation.offset;
  return item;
}

std::optional<float> lengthOf(const model::Annotation& annotation, const model::Scene& scene) {
  if (annotation.kind != model::AnnotationKind::distance)
    return std::nullopt;
  return glm::length(*scene.placeOf(annotation.anchors[1]) - *scene.placeOf(annotation.anchors[0]));
}

}  // namespace

std::string plainText(const ShownLabel& label) {
  return model::plainText(label.item.kind, label.text);
}

std::vector<ShownLabel> shownLabels(const model::Scene& scene, const Screen& screen,
                                    const std::string& language, model::MeshTrees& trees) {
  const Sights sights(scene, trees);
  std::vector<ShownLabel> labels;
  int number = 0;
  for (const model::Annotation& annotation : scene.annotations()) {
    if (!annotation.visible)
      continue;
    ++number;
    if (std::optional<LabelItem> item = itemOf(annotation, scene, screen, sights))
      labels.push_back({*std::move(item), model::writtenIn(annotation, language), number,
                        annotation.colour, lengthOf(annotation, scene)});
  }
  return labels;
}

UnseenLabels unseenLabels(const model::Scene& scene, const Screen& screen,
                          model::MeshTrees& trees) {
  const Sights sights(scene, trees);
  UnseenLabels unseen;
  for (const model::Annotation& annotation : scene.annotations()) {
    if (!annotation.visible)
      continue;
    const auto& anchors = annotation.anchors;
    const auto within = [&](const model::Anchor& anchor) {
      const std::optional<glm::vec2> place = screen.place(*scene.placeOf(anchor));
      return place && screen.inside(*place);
    };
    if (!std::all_of(anchors.begin(), anchors.end(),
                     [&](const model::Anchor& anchor) { return sights.shows(anchor); }))
      unseen.notDrawn.push_back(annotation.id);
    else if (!std::all_of(anchors.begin(), anchors.end(), within))
      unseen.offPicture.push_back(annotation.id);
  }
  return unseen;
}

}  // namespace sline::render
