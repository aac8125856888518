// SPDX-License-Identifier: Apache-2.0
// Edits of annotations: Scene → Scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

/// Null where there is none of that id.
const Annotation* findAnnotation(const Scene& scene, AnnotationId id);

/// Adds the annotation under a fresh id, last of all. A faulty one, or one on a surface that is not
/// in the scene, changes nothing.
Edited withAnnotation(const Scene& scene, const Annotation& annotation);
/// The same, and no saved view loses it that is to show all there is: those that have left out none
/// so far list it, and so does the view of that place among the scene's.
Edited withAnnotationMade(const Scene& scene, const Annotation& annotation,
                          std::optional<std::size_t> view);
/// Gives the annotation of that id all of `annotation` but its id; refuses what `withAnnotation`
/// refuses.
Edited withAnnotationChanged(const Scene& scene, AnnotationId id, const Annotation& annotation);
/// Removes them, from saved views too.
Edited withoutAnnotations(const Scene& scene, std::span<const AnnotationId> ids);

/// That view, of that place among the scene's, alone shows the annotation, of those views too that
/// list none: it is not seen without a view, and the view lists it, besides all that are visible
/// where it had no list.
Edited withAnnotationOnlyInView(const Scene& scene, AnnotationId id, std::size_t view);
/// That view alone, of all saved ones, shows the annotation, or, where none is named, every view
/// does. What is seen now stays: that is the annotation's own visibility.
Edited withAnnotationShownIn(const Scene& scene, AnnotationId id, std::optional<std::size_t> view);
/// The views of these places show the annotations, or do not; the others stay as they are, and so
/// does what is seen now.
Edited withAnnotationsTicked(const Scene& scene, std::span<const AnnotationId> ids,
                             std::span<const std::size_t> views, bool shown);
/// Which of the saved views show it, by their places.
std::vector<std::size_t> viewsShowing(const Scene& scene, AnnotationId id);

}  // namespace sline::model
