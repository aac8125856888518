// SPDX-License-Identifier: Apache-2.0
// Makes sections as the user adds them.
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
  std::optional<glm::vec3> through;  ///< if absent, the middle of what is shown
};

/// Returns a section that is not yet in the scene. It removes the side towards the camera, so that
/// the cut face is seen; a `facing` section is perpendicular to the line of sight.
model::Section newSection(const model::Scene& scene, const model::Camera& camera,
                          const SectionWish& wish);
/// Returns the node that holds all of them: the one node, or the nearest group above all; the root
/// for none.
model::NodeId commonNode(const model::Scene& scene, const NodeIds& ids);
/// Returns plain text that tells the user what a section cuts.
QString scopeText(Session& session, model::NodeId scope);

}  // namespace sline::widgets
