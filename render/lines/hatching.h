// SPDX-License-Identifier: Apache-2.0
// Hatching as curves (METHOD §6): strokes run along the light gradient k through seeds on nested
// lattices, thicken with the tone, keep clear of each other and end where the tone does. ▲ S §3.4
// searches along k in screen space, pixel by pixel; here the same seeds, field and weights give
// curves on the surface, which have a definite edge at any size, stay with the surface while the
// camera turns, and are what vector export needs. All lengths in λ (see ViewScale).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "model/geometry/surface.h"
#include "model/scene/camera.h"

namespace sline::render {

/// Names a seed for as long as its mesh lives: a point of the lattice with cells of F_c·2^−level in
/// the plane across `axis`, the coarsest lattice that has it.
struct HatchSeed {
  int axis = 0;   ///< 0 … 2: the axis nearest to the surface's normal
  int level = 0;  ///< lattices of higher levels contain those of lower ones
  std::int32_t i = 0;
  std::int32_t j = 0;
  bool operator==(const HatchSeed&) const = default;
};

struct HatchPoint {
  glm::vec3 position{0.0f};  ///< on the surface, patient frame, mm
  glm::vec3 normal{0.0f};    ///< unit, on the side that faces the eye
  float halfWidth = 0.0f;    ///< λ
};

/// Points `first` … `first + count − 1` of `Hatching::points`, in drawing order.
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

struct HatchingRequest {
  float entered = 1.0f;         ///< T_H, 0 … 1; the amount of ink grows with it evenly
  float spacing = 7.5f;         ///< λ between the middles of neighbouring strokes
  float tone = 1.0f;            ///< times the strokes' width
  float length = 140.0f;        ///< λ, the longest stroke; 0 makes dots (stippling, S fig. 10)
  float aspect = 16.0f / 9.0f;  ///< of the picture: seeds outside of it are left out
  bool twoSided = false;        ///< see LineRequest
};

/// Strokes of everything within the picture that faces the eye, whether or not something hides it.
/// The result depends on nothing but the arguments, not on threads.
Hatching extractHatching(const model::Surface& surface, const model::FaceNeighbours& neighbours,
                         const model::Camera& camera, const HatchingRequest& request);

}  // namespace sline::render
