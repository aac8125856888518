// SPDX-License-Identifier: Apache-2.0
// Hatching as curves (METHOD §6): strokes laid over the surface once thicken with the tone of the
// view and end where the tone does. ▲ S §3.4 searches along k in screen space, pixel by pixel;
// curves on the surface have a definite edge at any size, stay where they are while the camera
// turns, and are what vector export needs. All lengths in λ (see ViewScale).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/base/units.h"
#include "model/scene/camera.h"
#include "model/scene/light.h"
#include "render/lines/stroke_layout.h"

namespace sline::render {

struct HatchPoint {
  glm::vec3 position{0.0f};  ///< on the surface, patient frame, mm
  glm::vec3 normal{0.0f};    ///< unit, on the side that faces the eye
  float halfWidth = 0.0f;    ///< λ
};

/// Points `first` … `first + count − 1` of `Hatching::points`, in drawing order. What is seen of
/// one stroke on the surface may come in several pieces.
struct HatchStroke {
  HatchSeed seed;
  glm::vec3 seedPosition{0.0f};
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct Hatching {
  std::vector<HatchPoint> points;
  std::vector<HatchStroke> strokes;
};

/// λ between the middles of neighbouring strokes when they are just far enough apart for others to
/// grow in between, and of the longest stroke then.
inline constexpr float hatchSpacing = 7.5f;
inline constexpr float longestHatchStroke = 140.0f;

using model::upperLeftLight;

/// λ between strokes of that density. Were strokes as long as the places that they hatch, their
/// number would grow as fast as they come closer; were they as short as their layout lets them,
/// with its square; they are between both. Levels of the layout grow in one after the other, so
/// that density varies as evenly as zoom does, and costs what a view from as much nearer would.
float spacingOf(HatchDensity density);

struct HatchingRequest {
  float entered = 1.0f;              ///< T_H, 0 … 1; the amount of ink grows with it evenly
  float spacing = hatchSpacing;      ///< λ between strokes
  float tone = 1.0f;                 ///< times the strokes' width; some white stays
  glm::vec3 light = upperLeftLight;  ///< towards what leaves form shadows, in the camera's frame
  float aspect = 16.0f / 9.0f;       ///< of the picture: strokes outside of it are left out
  bool twoSided = false;             ///< see LineRequest
};

/// Strokes of everything within the picture that faces the eye, whether or not something hides it;
/// dots (stippling, S fig. 10) where the layout has them. The result depends on nothing but the
/// arguments: not on threads, nor on what the layout was asked for before.
Hatching extractHatching(StrokeLayout& layout, const model::Camera& camera,
                         const HatchingRequest& request);

}  // namespace sline::render
