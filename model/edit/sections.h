// SPDX-License-Identifier: Apache-2.0
// Edits section planes: Scene → Scene.
#pragma once

#include <optional>
#include <span>

#include "model/edit/edited.h"

namespace sline::model {

/// Returns a sagittal, coronal or axial section that keeps the given side of everything in `scope`;
/// at `mm` along x, y or z of LPS, else through the middle of the visible structures' bounds. It is
/// not yet in the scene.
Section anatomicalSection(const Scene& scene, NodeId scope, AnatomicalView kept,
                          std::optional<float> mm = std::nullopt);

/// Adds the section under a fresh id at the end. A faulty plane, a scope that is not in the scene,
/// or one section more than a structure can have (`maximumSections`) changes nothing.
Edited withSection(const Scene& scene, const Section& section);
/// Gives the section of that id all of `section` but its id; refuses what `withSection` refuses.
Edited withSectionChanged(const Scene& scene, SectionId id, const Section& section);
Edited withoutSections(const Scene& scene, std::span<const SectionId> ids);

}  // namespace sline::model
