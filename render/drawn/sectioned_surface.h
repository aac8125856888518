// SPDX-License-Identifier: Apache-2.0
// Cuts a surface by section planes, independently of the view.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/geometry/surface.h"
#include "model/scene/section.h"
#include "render/drawn/pattern_cache.h"
#include "render/lines/patterns/cut_faces.h"

namespace sline::render {

struct SectionedSurface {
  model::SurfacePtr surface;
  std::vector<model::Plane> planes;
  std::vector<CutFace> faces;  ///< one per plane
  std::shared_ptr<PatternCache> patterns;
};

SectionedSurface sectioned(const model::SurfacePtr& surface, std::vector<model::Plane> planes);

/// Keeps cut surfaces while their planes stay where they are. `Cut` is a `SectionedSurface`, or a
/// type that adds to it and is made of it.
template <class Cut>
class SectionCache {
 public:
  std::shared_ptr<Cut> at(const model::SurfacePtr& surface,
                          std::span<const model::Section> sections) {
    std::vector<model::Plane> planes = model::planesOf(sections);
    for (Entry& entry : m_entries)
      if (entry.cut->surface == surface && entry.cut->planes == planes) {
        entry.used = true;
        return entry.cut;
      }
    m_entries.push_back({std::make_shared<Cut>(sectioned(surface, std::move(planes))), true});
    return m_entries.back().cut;
  }
  /// Forgets surfaces that were not asked for since the last call.
  void forgetUnused() {
    std::erase_if(m_entries, [](const Entry& entry) { return !entry.used; });
    for (Entry& entry : m_entries)
      entry.used = false;
  }

 private:
  struct Entry {
    std::shared_ptr<Cut> cut;
    bool used = true;
  };
  std::vector<Entry> m_entries;
};

/// Returns those of the sections that take any of the box away, at most `maximumSections`: a
/// structure that they all spare is drawn as if there were none.
std::vector<model::Section> sectionsThatCut(std::vector<model::Section> sections,
                                            const model::Box& box);
/// Returns whether they have the same planes and look.
bool alike(std::span<const model::Section> a, std::span<const model::Section> b);

/// Returns the corner of the box that lies farthest in that direction.
glm::vec3 cornerAlong(const model::Box& box, const glm::vec3& direction);

/// Returns the planes as sections.glsl wants them.
std::vector<glm::vec4> sectionVectors(std::span<const model::Plane> planes);

}  // namespace sline::render
