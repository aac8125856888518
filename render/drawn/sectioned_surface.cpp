// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/sectioned_surface.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace sline::render {

SectionedSurface sectioned(const model::SurfacePtr& surface, std::vector<model::Plane> planes) {
  std::vector<CutFace> faces = cutFaces(*surface, planes);
  return {surface, std::move(planes), std::move(faces), std::make_shared<PatternCache>()};
}

glm::vec3 cornerAlong(const model::Box& box, const glm::vec3& direction) {
  return glm::mix(box.low, box.high, glm::greaterThan(direction, glm::vec3(0.0f)));
}

std::vector<model::Section> sectionsThatCut(std::vector<model::Section> sections,
                                            const model::Box& box) {
  std::erase_if(sections, [&box](const model::Section& section) {
    return !(section.plane.distance(cornerAlong(box, section.plane.normal)) > 0.0);
  });
  if (sections.size() > model::maximumSections)
    sections.resize(model::maximumSections);
  return sections;
}

bool alike(std::span<const model::Section> a, std::span<const model::Section> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const model::Section& x, const model::Section& y) {
                      return x.plane == y.plane && x.faces == y.faces && x.hatched == y.hatched;
                    });
}

std::vector<glm::vec4> sectionVectors(std::span<const model::Plane> planes) {
  std::vector<glm::vec4> vectors;
  for (const model::Plane& plane : planes)
    vectors.emplace_back(plane.normal, -plane.offset);
  return vectors;
}

}  // namespace sline::render
