// SPDX-License-Identifier: Apache-2.0
// Edits saved views and converts between them and what is on screen. Views are identified by their
// index, as their order is that of the tour.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

struct AppliedView {
  Scene scene;
  std::vector<NodeId> absent;  ///< nodes that the view mentions but the scene lacks
};

/// Returns the scene as the view shows it: with its sections, looks, annotations and focus as far
/// as it has any; everything else stays, and so do nodes that came after the view.
AppliedView withViewApplied(const Scene& scene, const View& view);

/// Returns the looks of all nodes, from which `withViewApplied` restores the picture: structures
/// with their inherited fields answered (except an ink without a colour of its own), groups with
/// their visibility.
std::vector<Look> looksOf(const Scene& scene);

/// Returns how many nodes and annotations the view mentions that the scene lacks.
std::size_t absentFrom(const Scene& scene, const View& view);

/// Returns a view of the current picture: camera, looks of all nodes, sections, the annotations
/// that are shown and what is in focus.
View viewOf(const Scene& scene, const Camera& camera, std::string name);

/// Returns the name without blanks at its ends; where another view already has it (as
/// `normalisedName` compares), the first number that makes it unique is added: "Front 2". The view
/// at `but` may have the name.
std::string freeViewName(const Scene& scene, const std::string& wanted,
                         std::optional<std::size_t> but = std::nullopt);

/// Returns the scene with these saved views instead of its own.
Edited withViews(const Scene& scene, std::vector<View> views);

/// Adds the view at the end, by a free name. Without a name, or with a faulty camera, nothing
/// changes.
Edited withView(const Scene& scene, View view);
/// Adds a view of the current picture. Of its labels it has those that no saved view shows
/// (annotations.h), and the picture then has these alone, as the view has.
Edited withNewView(const Scene& scene, const Camera& camera, std::string name);
/// Makes the view show what `seen` does; it keeps its name, its words and the unread keys of its
/// file.
Edited withViewUpdated(const Scene& scene, std::size_t index, const View& seen);
/// Renames the view to a free name; an empty name changes nothing.
Edited withViewRenamed(const Scene& scene, std::size_t index, const std::string& name);
/// Says that with the view; a time without sense changes nothing.
Edited withViewWords(const Scene& scene, std::size_t index, const ViewWords& words);
/// Moves the view to index `to`; an index beyond the end means the end.
Edited withViewMoved(const Scene& scene, std::size_t index, std::size_t to);
Edited withoutView(const Scene& scene, std::size_t index);

/// Returns the scene with the key light, or without one. A faulty light changes nothing.
Edited withKeyLight(const Scene& scene, const std::optional<KeyLight>& light);

}  // namespace sline::model
