// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/section_caps.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "model/base/contrast.h"
#include "render/drawn/surface_fill.h"

namespace sline::render {

namespace {

/// The share of the structure's colour over the background, on the cut face of a structure without
/// fill.
constexpr float lightTint = 0.35f;
/// The share of the face's colour times the structure's that gives the strokes on it, where the pen
/// has no colour.
constexpr float strokeShade = 0.75f;
/// The least contrast of a pattern's ink to its face.
constexpr double patternContrast = 3.0;
constexpr float strokeSpacing = 9.0f;  // λ
constexpr float strokeWidth = 1.2f;    // λ

/// Returns a small way towards the eye (window depth), as faces of one plane would lie equally
/// deep.
float lift(const CutFace& face, const PictureView& view) {
  return outlineLift / outlineSteps * faceSteps(face.capArea, view.bounds().size());
}

/// Returns the window depth on the plane over pixels from the picture's middle. A plane seen
/// edge-on has none, and no pixels either.
glm::vec3 depthPlane(const model::Plane& plane, const PictureView& view) {
  const glm::dmat4 toClip(view.viewProjection());
  const glm::dvec4 q = glm::transpose(glm::inverse(toClip)) *
                       glm::dvec4(glm::dvec3(plane.normal), -double(plane.offset));
  if (q.z == 0.0)
    return {0.0f, 0.0f, 0.0f};
  const glm::dvec2 size(view.size());
  return {-q.x / q.z / size.x, -q.y / q.z / size.y, 0.5 - 0.5 * q.w / q.z};
}

/// Returns stripes at 45° between the plane's own axes, rising or falling so that neighbours
/// differ. Their distance in millimetres is a power of two, so they stay in place while the picture
/// is zoomed; every other one enters gradually.
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

Colour asColour(const glm::vec3& rgb) {
  const glm::vec3 c = 255.0f * glm::clamp(rgb, 0.0f, 1.0f) + 0.5f;
  return {std::uint8_t(c.r), std::uint8_t(c.g), std::uint8_t(c.b)};
}

/// Returns the face's colour: the structure's own where that is shaded, else a tint. Under a
/// pattern it is never so dark (on a dark ground: so light) that the strokes are lost in it.
glm::vec3 faceColour(const DrawnStructure& shown, Background background, std::size_t face) {
  const glm::vec3 paper = paperColour(background);
  if (isPaperFace(shown.sections[face].faces, shown.pattern))
    return paper;
  float filled = capTint(shown.style.gamma.value());
  const auto colour = [&] { return glm::mix(paper, rgb(shown.style.colour), filled); };
  if (showsPattern(shown, face)) {
    const Colour ink = inkColour(shown.style, background);
    while (filled > lightTint && contrastBetween(asColour(colour()), ink) < patternContrast)
      filled -= 0.02f;
  }
  return colour();
}

}  // namespace

float faceSteps(double area, const glm::vec3& sceneSize) {
  const double whole = double(glm::dot(sceneSize, sceneSize));
  const double halvings = std::log2(whole / std::max(area, 1e-9 * whole));
  return float(std::round(16.0 * std::max(halvings, 0.0)));
}

float inFront(float distance, float steps) {
  constexpr float step = 2.5e-7f;
  return distance - step * steps * std::abs(distance);
}

bool isPaperFace(model::CutFaces faces, model::CutPattern pattern) {
  if (faces == model::CutFaces::tint)
    return pattern == model::CutPattern::rim;
  return faces == model::CutFaces::off || model::isOpenWithin(pattern);
}

float capTint(float gamma) {
  const float shaded = std::clamp(gamma - 3.0f, 0.0f, 1.0f);
  return lightTint + (1.0f - lightTint) * shaded;
}

bool isCutAway(const DrawnStructure& shown, const model::Box& box) {
  return std::any_of(shown.sections.begin(), shown.sections.end(),
                     [&box](const model::Section& section) {
                       return section.plane.distance(cornerAlong(box, -section.plane.normal)) > 0.0;
                     });
}

bool isCutAway(const DrawnStructure& shown, const model::Sphere& sphere) {
  return std::any_of(shown.sections.begin(), shown.sections.end(),
                     [&sphere](const model::Section& section) {
                       return section.plane.distance(sphere.centre) > 1.00001 * sphere.radius;
                     });
}

bool hasCaps(const DrawnStructure& shown) {
  return shown.cut && shown.style.opacity.value() > 0.0f &&
         std::any_of(shown.cut->faces.begin(), shown.cut->faces.end(),
                     [](const CutFace& face) { return !face.cap.empty(); });
}

bool showsPattern(const DrawnStructure& shown, std::size_t face) {
  return shown.pattern != model::CutPattern::plain && shown.pattern != model::CutPattern::blank &&
         shown.sections[face].faces == model::CutFaces::tissue;
}

PixelRect sectionArea(const DrawnStructure& shown, const PictureView& view) {
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

glm::vec3 capDepth(const DrawnStructure& shown, const PictureView& view, std::size_t face) {
  const CutFace& cut = shown.cut->faces[face];
  return depthPlane(cut.plane, view) - glm::vec3(0.0f, 0.0f, lift(cut, view));
}

CapPaint capPaint(const DrawnStructure& shown, const PictureView& view, Background background,
                  std::size_t face) {
  const CutFace& cut = shown.cut->faces[face];
  const glm::vec3 own = rgb(shown.style.colour);
  const glm::vec3 colour = faceColour(shown, background, face);
  const float opacity = shown.style.opacity.value();
  const glm::vec3 stroke = shown.style.inkColour ? rgb(*shown.style.inkColour)
                                                 : glm::mix(colour, colour * own, strokeShade);
  const bool hatched = shown.sections[face].hatched && !showsPattern(shown, face);
  return {.colour = opacity * glm::vec4(colour, 1.0f),
          .strokeColour = hatched ? opacity * glm::vec4(stroke, 1.0f) : glm::vec4(0.0f),
          .stripes = stripes(cut.plane, view, shown.id.value % 2 == 0),
          .strokeHalfWidth = 0.5f * strokeWidth * view.outputUnit(),
          .depthPlane = capDepth(shown, view, face)};
}

}  // namespace sline::render
