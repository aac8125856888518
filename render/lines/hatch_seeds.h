// SPDX-License-Identifier: Apache-2.0
// Seeds of hatching: where lattice lines pierce the surface (METHOD §6.2, §6.7). ▲ S projects along
// the normal onto the faces of a grid's cells; here lattice points are projected along the axis
// nearest to the face's normal, so a seed is a point of the surface, and lattices nest: zooming
// adds seeds and moves none.
#pragma once

#include <vector>

#include "render/lines/hatch_tone.h"
#include "render/lines/view_scale.h"

namespace sline::render {

struct PlacedSeed {
  HatchSeed name;
  std::uint32_t triangle = 0;
  glm::vec3 barycentric{0.0f};
  glm::vec3 position{0.0f};
  float weight = 0.0f;    ///< see HatchField
  float angle = 0.0f;     ///< see HatchField
  float presence = 0.0f;  ///< 0 … 1: seeds of the finest lattice grow from nothing
};

/// Seeds on the hatched clusters within the picture, the coarsest lattice first and then in an
/// order that scatters them: the order in which strokes may take their place. The lattice's origin
/// is the middle of the bounding sphere. The cells of the finest whole
/// lattice are 0.7 to 1.4 times as wide as `spacing`.
std::vector<PlacedSeed> hatchSeeds(const model::Surface& surface, const HatchFields& fields,
                                   const ViewScale& scale, const HatchingRequest& request);

}  // namespace sline::render
