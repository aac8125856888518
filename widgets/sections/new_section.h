// SPDX-License-Identifier: Apache-2.0
// Sections as a person adds them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "model/edit/sections.h"
#include "widgets/session/session.h"

namespace sline::widgets {

enum class SectionKind { sagittal, coronal, axial, facing };

struct SectionWish {
  SectionKind kind = SectionKind::sagittal;
  model::NodeId scope = model::rootId;
  std::optional<glm::vec3> through;  ///< absent: the middle of what is shown
};

/// Not yet in the scene. The side towards the camera goes, so that the cut face is seen; `facing`
/// stands across the line of sight.
model::Section newSection(const model::Scene& scene, const model::Camera& camera,
                          const SectionWish& wish);
/// The node that holds all of them: the one, or the nearest group above all; the root for none.
model::NodeId commonNode(const model::Scene& scene, const NodeIds& ids);
/// What a section cuts, for people; plain text.
QString scopeText(Session& session, model::NodeId scope);

}  // namespace sline::widgets
