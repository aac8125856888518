// SPDX-License-Identifier: Apache-2.0
#include "model/edit/sections.h"

#include <algorithm>
#include <array>

namespace sline::model {

namespace {

bool isSound(const Scene& scene, const Section& section) {
  return !planeFault(section.plane) && (section.scope == rootId || scene.find(section.scope));
}

/// Returns the edit, or no change where a structure would have too many sections.
Edited ifFewEnough(const Scene& before, Scene after) {
  const auto& nodes = after.nodes();
  const bool crowded = std::any_of(nodes.begin(), nodes.end(), [&after](const Node& node) {
    return !node.isGroup() && after.sectionsOf(node.id).size() > maximumSections;
  });
  return crowded ? Edited{before, false} : Edited{std::move(after), true};
}

}  // namespace

Section anatomicalSection(const Scene& scene, NodeId scope, AnatomicalView kept,
                          std::optional<float> mm) {
  static constexpr std::array<const char*, 3> names{"Sagittal section", "Coronal section",
                                                    "Axial section"};
  const int axis = axisOf(kept);
  if (!mm) {
    const Box bounds = scene.visibleBounds(scope);
    mm = bounds.empty() ? 0.0f : bounds.centre()[axis];
  }
  Section section;
  section.name = names[std::size_t(axis)];
  section.plane = anatomicalPlane(kept, *mm);
  section.scope = scope;
  return section;
}

Edited withSection(const Scene& scene, const Section& section) {
  if (!isSound(scene, section))
    return {scene, false};
  Scene after = scene;
  after.appendSection(section);
  return ifFewEnough(scene, std::move(after));
}

Edited withSectionChanged(const Scene& scene, SectionId id, const Section& section) {
  if (!isSound(scene, section))
    return {scene, false};
  std::vector<Section> sections = scene.sections();
  for (Section& old : sections)
    if (old.id == id) {
      old = section;
      old.id = id;
    }
  if (sections == scene.sections())
    return {scene, false};
  Scene after = scene;
  after.setSections(std::move(sections));
  return ifFewEnough(scene, std::move(after));
}

Edited withoutSections(const Scene& scene, std::span<const SectionId> ids) {
  std::vector<Section> sections = scene.sections();
  const auto named = [ids](const Section& section) {
    return std::find(ids.begin(), ids.end(), section.id) != ids.end();
  };
  if (std::erase_if(sections, named) == 0)
    return {scene, false};
  Scene after = scene;
  after.setSections(std::move(sections));
  return {std::move(after), true};
}

}  // namespace sline::model
