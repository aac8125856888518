// SPDX-License-Identifier: Apache-2.0
// Edits of annotations: Scene → Scene (see model/edit/style.h for `Edited`).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/edit/style.h"

namespace sline::model {

/// Null where there is none of that id.
const Annotation* findAnnotation(const Scene& scene, AnnotationId id);

/// Adds the annotation under a fresh id, last of all. A faulty one, or one on a surface that is not
/// in the scene, changes nothing.
Edited withAnnotation(const Scene& scene, const Annotation& annotation);
/// Gives the annotation of that id all of `annotation` but its id; refuses what `withAnnotation`
/// refuses.
Edited withAnnotationChanged(const Scene& scene, AnnotationId id, const Annotation& annotation);
/// Removes them, from saved views too.
Edited withoutAnnotations(const Scene& scene, std::span<const AnnotationId> ids);

/// The view, of that place among the scene's, shows the annotation: where it lists what it shows,
/// it lists this too. `alone`: no other shows it that does not list it, and a view without a list
/// gets one of all that are visible.
Edited withAnnotationInView(const Scene& scene, AnnotationId id, std::size_t view, bool alone);
/// That view alone, of all saved ones, shows the annotation, or, where none is named, every view
/// does. What is seen now stays: that is the annotation's own visibility.
Edited withAnnotationShownIn(const Scene& scene, AnnotationId id, std::optional<std::size_t> view);
/// Which of the saved views show it, by their places.
std::vector<std::size_t> viewsShowing(const Scene& scene, AnnotationId id);

}  // namespace sline::model
