// SPDX-License-Identifier: Apache-2.0
// Draws hatching as curves (METHOD §6): strokes laid over the surface once thicken with the tone of
// the view and end where the tone does. ▲ S §3.4 searches along k in screen space, pixel by pixel;
// curves on the surface have a definite edge at any size, stay where they are while the camera
// turns, and are what vector export needs. All lengths are in λ (see ViewScale).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/base/units.h"
#include "model/camera/camera.h"
#include "model/scene/light.h"
#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

struct HatchPoint {
  glm::vec3 position{0.0f};  ///< on the surface, patient frame, mm
  glm::vec3 normal{0.0f};    ///< unit, on the side that faces the eye
  float halfWidth = 0.0f;    ///< λ
  float ink = 1.0f;  ///< a factor on width and opacity, 0 … 1, where Γ varies over the structure
};

/// Points `first` … `first + count − 1` of `Hatching::points`, in drawing order. The visible part
/// of one stroke on the surface may come in several pieces.
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
/// grow in between, and the length of the longest stroke then.
inline constexpr float hatchSpacing = 7.5f;
inline constexpr float longestHatchStroke = 140.0f;

using model::upperLeftLight;

/// Returns the λ between strokes of that density. If strokes were as long as the places that they
/// hatch, their number would grow as fast as they come closer; if they were as short as their
/// layout lets them, it would grow with the square; they are between both. Levels of the layout
/// grow in one after the other, so that density varies as evenly as zoom does, and costs as much as
/// a view from correspondingly nearer would.
float spacingOf(HatchDensity density);

struct HatchingRequest {
  float entered = 1.0f;              ///< T_H, 0 … 1; the amount of ink grows evenly with it
  std::span<const float> gammas;     ///< Γ per vertex, which then says T_H; empty: `entered` does
  float spacing = hatchSpacing;      ///< λ between strokes
  float tone = 1.0f;                 ///< a factor on the strokes' width; some white always stays
  glm::vec3 light = upperLeftLight;  ///< towards the light of form shadows, in the camera's frame
  float aspect = 16.0f / 9.0f;       ///< of the picture; strokes outside it are left out
  bool twoSided = false;             ///< see LineRequest
  std::size_t mostCells = mostHatchCells;  ///< of the layout, to look at
};

/// Returns the strokes of everything within the picture that faces the eye, hidden or not; dots
/// (stippling, S fig. 10) where the layout has them. The result depends on nothing but the
/// arguments: neither on threads nor on earlier uses of the layout.
Hatching extractHatching(StrokeLayout& layout, const model::Camera& camera,
                         const HatchingRequest& request);

}  // namespace sline::render
