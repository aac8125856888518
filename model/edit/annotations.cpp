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

std::vector<AnnotationId> visibleOnes(const Scene& scene) {
  std::vector<AnnotationId> ids;
  for (const Annotation& annotation : scene.annotations())
    if (annotation.visible)
      ids.push_back(annotation.id);
  return ids;
}
}  // namespace

const Annotation* findAnnotation(const Scene& scene, AnnotationId id) {
  const std::vector<Annotation>& all = scene.annotations();
  const auto found = std::find_if(
      all.begin(), all.end(), [id](const Annotation& annotation) { return annotation.id == id; });
  return found == all.end() ? nullptr : &*found;
}

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
  if (alone && !shown)
    shown = visibleOnes(scene);
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

Edited withAnnotationShownIn(const Scene& scene, AnnotationId id, std::optional<std::size_t> view) {
  std::vector<View> views = scene.views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::optional<std::vector<AnnotationId>>& listed = views[i].annotations;
    std::vector<AnnotationId> now = listed ? *listed : visibleOnes(scene);
    const auto at = std::find(now.begin(), now.end(), id);
    const bool wanted = !view || *view == i;
    if (wanted == (at != now.end()))
      continue;
    if (wanted)
      now.push_back(id);
    else
      now.erase(at);
    listed = std::move(now);
  }
  const bool changed = views != scene.views();
  Scene after = scene;
  after.setViews(std::move(views));
  return {std::move(after), changed};
}

std::vector<std::size_t> viewsShowing(const Scene& scene, AnnotationId id) {
  std::vector<std::size_t> showing;
  const std::vector<AnnotationId> visible = visibleOnes(scene);
  for (std::size_t i = 0; i < scene.views().size(); ++i) {
    const std::optional<std::vector<AnnotationId>>& listed = scene.views()[i].annotations;
    const std::vector<AnnotationId>& shown = listed ? *listed : visible;
    if (std::find(shown.begin(), shown.end(), id) != shown.end())
      showing.push_back(i);
  }
  return showing;
}

}  // namespace sline::model
