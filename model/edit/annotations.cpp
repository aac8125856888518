// SPDX-License-Identifier: Apache-2.0
#include "model/edit/annotations.h"

#include <algorithm>

#include "model/edit/views.h"

namespace sline::model {

namespace {
bool isSound(const Scene& scene, const Annotation& annotation) {
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

bool contains(const std::vector<AnnotationId>& ids, AnnotationId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool leftOutNone(const Scene& scene, const std::vector<AnnotationId>& listed) {
  return std::all_of(
      scene.annotations().begin(), scene.annotations().end(),
      [&listed](const Annotation& annotation) { return contains(listed, annotation.id); });
}

/// Makes the view show the annotation, or not.
void tick(const Scene& scene, View& view, AnnotationId id, bool shown) {
  std::vector<AnnotationId> now = view.annotations ? *view.annotations : visibleOnes(scene);
  if (shown == contains(now, id))
    return;
  if (shown)
    now.push_back(id);
  else
    std::erase(now, id);
  view.annotations = std::move(now);
}
}  // namespace

const Annotation* findAnnotation(const Scene& scene, AnnotationId id) {
  const std::vector<Annotation>& all = scene.annotations();
  const auto found = std::find_if(
      all.begin(), all.end(), [id](const Annotation& annotation) { return annotation.id == id; });
  return found == all.end() ? nullptr : &*found;
}

Edited withAnnotation(const Scene& scene, const Annotation& annotation) {
  if (!isSound(scene, annotation))
    return {scene, false};
  Scene after = scene;
  after.appendAnnotation(annotation);
  return {std::move(after), true};
}

Edited withAnnotationMade(const Scene& scene, const Annotation& annotation,
                          std::optional<std::size_t> view) {
  if (!isSound(scene, annotation))
    return {scene, false};
  std::vector<View> views = scene.views();
  Scene after = scene;
  const AnnotationId made = after.appendAnnotation(annotation);
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::optional<std::vector<AnnotationId>>& listed = views[i].annotations;
    if (!listed)
      listed = visibleOnes(scene);  // else it would show whatever comes
    if (i == view)
      listed->push_back(made);
  }
  after.setViews(std::move(views));
  return {std::move(after), true};
}

Edited withAnnotationForAll(const Scene& scene, const Annotation& annotation) {
  if (!isSound(scene, annotation))
    return {scene, false};
  std::vector<View> views = scene.views();
  Scene after = scene;
  const AnnotationId made = after.appendAnnotation(annotation);
  for (View& view : views)
    if (view.annotations && leftOutNone(scene, *view.annotations))
      view.annotations->push_back(made);
  after.setViews(std::move(views));
  return {std::move(after), true};
}

std::vector<AnnotationId> unclaimedAnnotations(const Scene& scene) {
  std::vector<AnnotationId> free = visibleOnes(scene);
  for (const View& view : scene.views())
    std::erase_if(free, [&view](AnnotationId id) {
      return view.annotations && contains(*view.annotations, id);
    });
  return free;
}

Edited withAnnotationChanged(const Scene& scene, AnnotationId id, const Annotation& annotation) {
  if (!isSound(scene, annotation))
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

Edited withAnnotationOnlyInView(const Scene& scene, AnnotationId id, std::size_t view) {
  std::vector<View> views = scene.views();
  std::vector<Annotation> annotations = scene.annotations();
  std::optional<std::vector<AnnotationId>>& shown = views.at(view).annotations;
  if (!shown)
    shown = visibleOnes(scene);
  if (!contains(*shown, id))
    shown->push_back(id);
  for (Annotation& annotation : annotations)
    if (annotation.id == id)
      annotation.visible = false;
  Scene after = scene;
  after.setViews(std::move(views));
  after.setAnnotations(std::move(annotations));
  const bool changed = after != scene;
  return {std::move(after), changed};
}

Edited withAnnotationShownIn(const Scene& scene, AnnotationId id, std::optional<std::size_t> view) {
  std::vector<View> views = scene.views();
  for (std::size_t i = 0; i < views.size(); ++i)
    tick(scene, views[i], id, !view || *view == i);
  return withViews(scene, std::move(views));
}

Edited withAnnotationsTicked(const Scene& scene, std::span<const AnnotationId> ids,
                             std::span<const std::size_t> views, bool shown) {
  std::vector<View> all = scene.views();
  for (const std::size_t place : views)
    for (const AnnotationId id : ids)
      tick(scene, all.at(place), id, shown);
  return withViews(scene, std::move(all));
}

std::vector<std::size_t> viewsShowing(const Scene& scene, AnnotationId id) {
  std::vector<std::size_t> showing;
  const std::vector<AnnotationId> visible = visibleOnes(scene);
  for (std::size_t i = 0; i < scene.views().size(); ++i) {
    const std::optional<std::vector<AnnotationId>>& listed = scene.views()[i].annotations;
    const std::vector<AnnotationId>& shown = listed ? *listed : visible;
    if (contains(shown, id))
      showing.push_back(i);
  }
  return showing;
}

}  // namespace sline::model
