// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/cut_faces.h"

#include <algorithm>

#include "model/cuts/plane_section.h"
#include "render/lines/hatching/clipping.h"

namespace sline::render {

namespace {

/// A share of F and of the distance from the origin: several roundings of a coordinate.
constexpr float hair = 1e-6f;

Segment lineOf(const model::CutSegment& cut) {
  return {.a = cut.a,
          .b = cut.b,
          .normalA = cut.normalA,
          .normalB = cut.normalB,
          .triangle = cut.triangle};
}

/// Returns the parts of the line where two planes meet that lie inside the solid: between every
/// second pair of points at which the line enters and leaves the first plane's section.
std::vector<Segment> corners(const model::PlaneSection& section, const model::Plane& plane,
                             const model::Plane& other) {
  const glm::dvec3 along = glm::cross(glm::dvec3(plane.normal), glm::dvec3(other.normal));
  if (!(glm::length(along) > 1e-4))
    return {};
  struct Mark {
    double at;
    glm::vec3 position;
    std::uint32_t triangle;
  };
  std::vector<Mark> marks;
  for (const model::CutSegment& s : section.segments) {
    if (other.keeps(s.a) == other.keeps(s.b))
      continue;
    const double a = other.distance(s.a);
    const double t = a / (a - other.distance(s.b));
    const glm::dvec3 p = glm::mix(glm::dvec3(s.a), glm::dvec3(s.b), t);
    marks.push_back({glm::dot(along, p), glm::vec3(p), s.triangle});
  }
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.at < b.at; });
  std::vector<Segment> lines;
  const glm::vec3 normal = glm::normalize(plane.normal + other.normal);
  for (std::size_t i = 0; i + 1 < marks.size(); i += 2)
    lines.push_back({.a = marks[i].position,
                     .b = marks[i + 1].position,
                     .normalA = normal,
                     .normalB = normal,
                     .triangle = marks[i].triangle});
  return lines;
}

}  // namespace

std::vector<model::Plane> otherPlanes(const model::Surface& surface,
                                      std::span<const model::Plane> planes, std::size_t index) {
  const float room = hair * (surface.featureSize + glm::length(surface.boundingSphere.centre));
  std::vector<model::Plane> others;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (i != index) {
      others.push_back(planes[i]);
      others.back().offset += room;
    }
  return others;
}

std::vector<CutFace> cutFaces(const model::Surface& surface, std::span<const model::Plane> planes) {
  std::vector<CutFace> faces;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    model::PlaneSection section = model::planeSection(surface, planes[i]);
    CutFace face{.plane = planes[i], .outline = {}, .cap = {}, .capArea = section.capArea};
    face.outline.reserve(section.segments.size());
    for (const model::CutSegment& segment : section.segments)
      face.outline.push_back(lineOf(segment));
    if (surface.solid)
      for (std::size_t k = i + 1; k < planes.size(); ++k) {
        const std::vector<Segment> lines = corners(section, planes[i], planes[k]);
        face.outline.insert(face.outline.end(), lines.begin(), lines.end());
      }
    clip(face.outline, otherPlanes(surface, planes, i));
    face.cap = std::move(section.cap);
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace sline::render
