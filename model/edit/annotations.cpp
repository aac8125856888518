// SPDX-License-Identifier: Apache-2.0
#include "model/edit/annotations.h"

#include <algorithm>

namespace sline::model {

namespace {
bool sound(const Scene& scene, const Annotation& annotation) {
  return !annotationFault(annotation) &&
         std::all_of(annotation.anchors.begin(), annotation.anchors.end(),
                     [&scene](const Anchor& anchor) { return scene.placeOf(anchor).has_value(); });
}
}  // namespace

Edited withAnnotation(const Scene& scene, const Annotation& annotation) {
  if (!sound(scene, annotation))
    return {scene, false};
  Scene after = scene;
  after.appendAnnotation(annotation);
  return {std::move(after), true};
}

Edited withAnnotationChanged(const Scene& scene, AnnotationId id, const Annotation& annotation) {
  if (!sound(scene, annotation))
    return {scene, false};
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& old : annotations)
    if (old.id == id) {
      old = annotation;
      old.id = id;
    }
  if (annotations == scene.annotations())
    return {scene, false};
  Scene after = scene;
  after.setAnnotations(std::move(annotations));
  return {std::move(after), true};
}

Edited withoutAnnotations(const Scene& scene, std::span<const AnnotationId> ids) {
  const auto named = [ids](AnnotationId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  std::vector<Annotation> annotations = scene.annotations();
  if (std::erase_if(annotations, [&](const Annotation& a) { return named(a.id); }) == 0)
    return {scene, false};
  std::vector<View> views = scene.views();
  for (View& view : views)
    if (view.annotations)
      std::erase_if(*view.annotations, named);
  Scene after = scene;
  after.setAnnotations(std::move(annotations));
  after.setViews(std::move(views));
  return {std::move(after), true};
}

Edited withAnnotationInView(const Scene& scene, AnnotationId id, std::size_t view, bool alone) {
  std::vector<View> views = scene.views();
  std::vector<Annotation> annotations = scene.annotations();
  std::optional<std::vector<AnnotationId>>& shown = views.at(view).annotations;
  if (alone && !shown) {
    shown.emplace();
    for (const Annotation& annotation : annotations)
      if (annotation.visible)
        shown->push_back(annotation.id);
  }
  if (shown && std::find(shown->begin(), shown->end(), id) == shown->end())
    shown->push_back(id);
  for (Annotation& annotation : annotations)
    if (annotation.id == id && alone)
      annotation.visible = false;
  Scene after = scene;
  after.setViews(std::move(views));
  after.setAnnotations(std::move(annotations));
  const bool changed = after != scene;
  return {std::move(after), changed};
}

}  // namespace sline::model
