// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_sections.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "render/picture/layer.h"

namespace sline::render {

namespace {

/// Of the structure's colour over the background, on the cut face of a structure without fill.
constexpr float lightTint = 0.35f;
/// Of the face's colour times the structure's: the strokes on it, where the pen has no colour.
constexpr float strokeShade = 0.75f;
constexpr float strokeSpacing = 9.0f;  // λ
constexpr float strokeWidth = 1.2f;    // λ

/// The corner that lies farthest in that direction.
glm::vec3 cornerAlong(const model::Box& box, const glm::vec3& direction) {
  return glm::mix(box.low, box.high, glm::greaterThan(direction, glm::vec3(0.0f)));
}

/// Faces of one plane would lie equally deep. The smaller comes first, so that what lies inside
/// another shows on its cut face: a step of depth for every 4 % of area.
float lift(const CutFace& face, const PictureView& view) {
  const glm::vec3 size = view.bounds().size();
  const double whole = double(glm::dot(size, size));
  const double halvings = std::log2(whole / std::max(face.capArea, 1e-9 * whole));
  return 1.2e-7f * float(std::round(16.0 * std::max(halvings, 0.0)));
}

/// Window depth on the plane over pixels from the picture's middle. A plane seen edge-on has none,
/// and no pixels either.
glm::vec3 depthPlane(const model::Plane& plane, const PictureView& view) {
  const glm::dmat4 toClip(view.viewProjection());
  const glm::dvec4 q = glm::transpose(glm::inverse(toClip)) *
                       glm::dvec4(glm::dvec3(plane.normal), -double(plane.offset));
  if (q.z == 0.0)
    return {0.0f, 0.0f, 0.0f};
  const glm::dvec2 size(view.size());
  return {-q.x / q.z / size.x, -q.y / q.z / size.y, 0.5 - 0.5 * q.w / q.z};
}

/// Stripes at 45° between the plane's own axes, rising or falling so that neighbours differ. Their
/// distance in millimetres is a power of two, so they stay in place while the picture is zoomed;
/// every other one enters gradually.
glm::vec4 stripes(const model::Plane& plane, const PictureView& view, bool falling) {
  const float unit = view.outputUnit() * view.millimetresPerPixel(view.bounds().centre());
  const float octave = std::log2(std::max(strokeSpacing * unit, 1e-20f));
  const float coarse = std::ceil(octave);
  const model::PlaneAxes axes = model::axesOf(plane);
  const glm::vec3 along(glm::normalize(axes.u + (falling ? axes.v : -axes.v)));
  return {along / std::exp2(coarse - 1.0f), coarse - octave};
}

glm::vec3 paperColour(Background background) {
  return background == Background::transparent ? glm::vec3(1.0f)
                                               : glm::vec3(backgroundColour(background));
}

}  // namespace

std::shared_ptr<SectionedSurface> SectionCache::at(const model::SurfacePtr& surface,
                                                   std::span<const model::Section> sections) {
  std::vector<model::Plane> planes = model::planesOf(sections);
  for (Entry& entry : m_entries)
    if (entry.cut->surface == surface && entry.cut->planes == planes) {
      entry.used = true;
      return entry.cut;
    }
  auto cut = std::make_shared<SectionedSurface>();
  cut->surface = surface;
  cut->faces = cutFaces(*surface, planes);
  cut->planes = std::move(planes);
  cut->caps.resize(cut->faces.size());
  m_entries.push_back({cut, true});
  return cut;
}

void SectionCache::forgetUnused() {
  std::erase_if(m_entries, [](const Entry& entry) { return !entry.used; });
  for (Entry& entry : m_entries)
    entry.used = false;
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
                      return x.plane == y.plane && x.hatched == y.hatched;
                    });
}

bool takenAway(const Shown& shown, const model::Box& box) {
  return std::any_of(shown.sections.begin(), shown.sections.end(),
                     [&box](const model::Section& section) {
                       return section.plane.distance(cornerAlong(box, -section.plane.normal)) > 0.0;
                     });
}

bool takenAway(const Shown& shown, const model::Sphere& sphere) {
  return std::any_of(shown.sections.begin(), shown.sections.end(),
                     [&sphere](const model::Section& section) {
                       return section.plane.distance(sphere.centre) > 1.00001 * sphere.radius;
                     });
}

std::vector<glm::vec4> sectionVectors(std::span<const model::Plane> planes) {
  std::vector<glm::vec4> vectors;
  for (const model::Plane& plane : planes)
    vectors.emplace_back(plane.normal, -plane.offset);
  return vectors;
}

bool hasCaps(const Shown& shown) {
  return shown.cut && shown.style.opacity.value() > 0.0f &&
         std::any_of(shown.cut->faces.begin(), shown.cut->faces.end(),
                     [](const CutFace& face) { return !face.cap.empty(); });
}

gpu::Rect sectionArea(const Shown& shown, const PictureView& view) {
  glm::vec2 low(1e6f);
  glm::vec2 high(-1e6f);
  for (const CutFace& face : shown.cut->faces)
    for (const Segment& s : face.outline)
      for (const glm::vec3& p : {s.a, s.b}) {
        const PictureView::Point seen = view.project(p);
        if (seen.w <= 0.0f)
          return view.whole();
        low = glm::min(low, glm::max(seen.pixel, glm::vec2(-1e6f)));
        high = glm::max(high, glm::min(seen.pixel, glm::vec2(1e6f)));
      }
  if (!(low.x <= high.x))
    return {};
  const int x = int(std::floor(low.x));
  const int y = int(std::floor(low.y));
  return {x, y, int(std::ceil(high.x)) - x, int(std::ceil(high.y)) - y};
}

void markCaps(const Shown& shown, const PictureView& view, TileMask& mask) {
  for (const CutFace& face : shown.cut->faces)
    for (std::size_t i = 0; i + 2 < face.cap.size(); i += 3) {
      const std::array<PictureView::Point, 3> p{
          view.project(face.cap[i]), view.project(face.cap[i + 1]), view.project(face.cap[i + 2])};
      if (std::min({p[0].w, p[1].w, p[2].w}) <= 0.0f) {
        mask.mark(view.whole());
        continue;
      }
      const glm::vec2 limit(1e6f);
      const glm::vec2 low =
          glm::clamp(glm::min(glm::min(p[0].pixel, p[1].pixel), p[2].pixel) - 1.0f, -limit, limit);
      const glm::vec2 high =
          glm::clamp(glm::max(glm::max(p[0].pixel, p[1].pixel), p[2].pixel) + 2.0f, -limit, limit);
      mask.mark({int(low.x), int(low.y), int(high.x - low.x) + 1, int(high.y - low.y) + 1});
    }
}

CapLook capLook(const Shown& shown, const PictureView& view, Background background,
                std::size_t face) {
  const CutFace& cut = shown.cut->faces[face];
  const float filled =
      lightTint + (1.0f - lightTint) * std::clamp(shown.style.gamma.value() - 3.0f, 0.0f, 1.0f);
  const glm::vec3 own = rgb(shown.style.colour);
  const glm::vec3 colour = glm::mix(paperColour(background), own, filled);
  const float opacity = shown.style.opacity.value();
  const glm::vec3 stroke = shown.style.inkColour ? rgb(*shown.style.inkColour)
                                                 : glm::mix(colour, colour * own, strokeShade);
  glm::vec3 depth = depthPlane(cut.plane, view);
  depth.z -= lift(cut, view);
  return {.colour = opacity * glm::vec4(colour, 1.0f),
          .strokeColour =
              shown.sections[face].hatched ? opacity * glm::vec4(stroke, 1.0f) : glm::vec4(0.0f),
          .stripes = stripes(cut.plane, view, shown.id.value % 2 == 0),
          .strokeHalfWidth = 0.5f * strokeWidth * view.outputUnit(),
          .depthPlane = depth};
}

CapDraws capDraws(const Shown& shown, const PictureView& view, Background background,
                  const gpu::Rect& area, const gpu::Rect& slot) {
  CapDraws result;
  SectionedSurface& cut = *shown.cut;
  result.planes.resize(cut.faces.size());
  for (std::size_t i = 0; i < cut.faces.size(); ++i) {
    if (cut.faces[i].cap.empty())
      continue;
    if (!cut.caps[i])
      cut.caps[i] = std::make_unique<passes::CapGeometry>(cut.faces[i].cap);
    result.planes[i] = sectionVectors(otherPlanes(*cut.surface, cut.planes, i));
    const CapLook look = capLook(shown, view, background, i);
    result.draws.push_back({.cap = *cut.caps[i],
                            .viewProjection = view.viewProjection(),
                            .pictureSize = view.size(),
                            .layer = area,
                            .slot = slot,
                            .otherSections = result.planes[i],
                            .colour = look.colour,
                            .strokeColour = look.strokeColour,
                            .stripes = look.stripes,
                            .strokeHalfWidth = look.strokeHalfWidth,
                            .depthPlane = look.depthPlane});
  }
  return result;
}

}  // namespace sline::render
