// SPDX-License-Identifier: Apache-2.0
// Finds which parts of a structure sections take away, and how its cut faces look (METHOD §7).
#pragma once

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_settings.h"
#include "render/drawn/picture_view.h"

namespace sline::render {

/// Returns whether one of the planes takes all of the box or sphere away.
bool isCutAway(const DrawnStructure& shown, const model::Box& box);
bool isCutAway(const DrawnStructure& shown, const model::Sphere& sphere);

/// Returns whether the structure has a cut face to fill.
bool hasCaps(const DrawnStructure& shown);
/// Returns whether the face of that index in `shown.cut` has the pattern of its tissue.
bool showsPattern(const DrawnStructure& shown, std::size_t face);
/// Returns the pixels that cut faces and their outlines can touch, strokes not included.
PixelRect sectionArea(const DrawnStructure& shown, const PictureView& view);

/// The distance towards the eye (window depth) at which the outlines of cut faces lie, so that no
/// face of the same plane covers half of them.
inline constexpr float outlineLift = 6e-5f;

/// Returns the depth of the face of that index in `shown.cut` over pixels from the picture's
/// middle: (slope in x, slope in y, depth in the middle). A face within another lies a hair in
/// front of it.
glm::vec3 capDepth(const DrawnStructure& shown, const PictureView& view, std::size_t face);

/// Returns by how many steps a face of that area lies in front of its plane, in a scene whose
/// bounds are that large: the smaller of two faces comes first, by a step for every 4 % of area, so
/// that a structure inside another shows on its cut face. Whoever says which of two faces of one
/// plane is seen asks this.
float faceSteps(double area, const glm::vec3& sceneSize);
/// Returns the distance from the eye, or a depth that grows with it, that many steps in front of
/// that one: each a few of the last digits of the number.
float inFront(float distance, float steps);
/// The steps by which the outlines of cut faces lie in front of all of them.
inline constexpr float outlineSteps = 500.0f;

/// Returns the share of the structure's colour in its tinted cut faces.
float capTint(float gamma);
/// Tells whether a face has no colour, but the paper's: where its section says so, and where the
/// structure is a wall or rim alone, so that a tint would fill with it what is something else.
bool isPaperFace(model::CutFaces faces, model::CutPattern pattern);

/// Describes how a cut face looks; see cap.frag.glsl.
struct CapPaint {
  glm::vec4 colour{0.0f};        ///< premultiplied
  glm::vec4 strokeColour{0.0f};  ///< premultiplied; alpha 0: no hatching
  glm::vec4 stripes{0.0f};
  float strokeHalfWidth = 0.0f;  ///< px
  glm::vec3 depthPlane{0.0f};
};
/// Returns the look of the face of that index in `shown.cut`.
CapPaint capPaint(const DrawnStructure& shown, const PictureView& view, Background background,
                  std::size_t face);

}  // namespace sline::render
