// SPDX-License-Identifier: Apache-2.0
// Roughens meshes on purpose, to see which techniques bear what segmentation and scanning leave on
// surfaces.
#pragma once

#include <array>
#include <string_view>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/geometry/mesh.h"

namespace sline::render {

/// Staircase: the slices of a label map, `amount` mean edges thick, stacked along z. Each vertex
/// moves along z towards the level of its slice, z' = z − 0.85·h/(2π)·sin(2πz/h), so that surfaces
/// are terraces with steep steps between them; as z' still grows with z, no triangle turns over.
/// Jitter: each vertex moves in a random direction, with a normal distribution whose deviation is
/// `amount` mean edges; the same for the same mesh.
enum class NoiseKind { staircase, jitter };
inline constexpr std::array<std::string_view, 2> noiseNames{"staircase", "jitter"};

struct Noise {
  NoiseKind kind = NoiseKind::staircase;
  float amount = 3.0f;  ///< mean edges
};
inline constexpr std::array<float, 2> usualNoise{3.0f, 0.1f};  ///< of each kind
inline constexpr Limits<float> noiseLimits{0.0f, 20.0f};

/// Reads "staircase", "jitter=0.2".
Result<Noise> parseNoise(std::string_view text);
/// Returns "staircase, 3 edges".
std::string noiseText(const Noise& noise);

/// Returns the mean length of the triangles' edges, mm.
float meanEdge(const model::Mesh& mesh);
/// Returns the roughened mesh, with the same triangles.
model::MeshPtr withNoise(const model::Mesh& mesh, const Noise& noise);

}  // namespace sline::render
