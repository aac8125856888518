// SPDX-License-Identifier: Apache-2.0
// Edits annotations: Scene → Scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

/// Returns the annotation, or null where there is none of that id.
const Annotation* findAnnotation(const Scene& scene, AnnotationId id);

/// Adds the annotation under a fresh id at the end. A faulty one, or one on a surface that is not
/// in the scene, changes nothing.
Edited withAnnotation(const Scene& scene, const Annotation& annotation);
/// Does the same as `withAnnotation` for the view at that index, which lists it: no other saved
/// view shows it. Without one none does, and it is the next new view's (`unclaimedAnnotations`).
Edited withAnnotationMade(const Scene& scene, const Annotation& annotation,
                          std::optional<std::size_t> view);
/// Does the same as `withAnnotation` for the whole scene: the saved views that have left out none
/// so far list it, too.
Edited withAnnotationForAll(const Scene& scene, const Annotation& annotation);
/// Returns the visible annotations that no saved view lists: they were made since the last one was
/// left, or no view chooses among labels so far, as in scenes of other programs. A new view takes
/// these.
std::vector<AnnotationId> unclaimedAnnotations(const Scene& scene);
/// Gives the annotation of that id all of `annotation` but its id; refuses what `withAnnotation`
/// refuses.
Edited withAnnotationChanged(const Scene& scene, AnnotationId id, const Annotation& annotation);
/// Removes the annotations, from saved views too.
Edited withoutAnnotations(const Scene& scene, std::span<const AnnotationId> ids);

/// Hides the annotation itself and lists it in the view at that index, so that a view without a
/// list no longer shows it. A view that had no list gets one of all visible annotations and this
/// one.
Edited withAnnotationOnlyInView(const Scene& scene, AnnotationId id, std::size_t view);
/// Makes that view alone, of all saved ones, show the annotation or, where no view is given, every
/// view. The picture on screen stays, since it depends on the annotation's own visibility.
Edited withAnnotationShownIn(const Scene& scene, AnnotationId id, std::optional<std::size_t> view);
/// Makes the views at these indices show the annotations, or not; the other views and the picture
/// on screen stay as they are.
Edited withAnnotationsTicked(const Scene& scene, std::span<const AnnotationId> ids,
                             std::span<const std::size_t> views, bool shown);
/// Returns the indices of the saved views that show the annotation.
std::vector<std::size_t> viewsShowing(const Scene& scene, AnnotationId id);

}  // namespace sline::model
