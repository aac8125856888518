// SPDX-License-Identifier: Apache-2.0
// Low-pass filters a surface: G. Taubin, T. Zhang, G. Golub, "Optimal Surface Smoothing as Filter
// Design" (ECCV 1996). The transfer function is a Hamming-windowed sinc, expanded in Chebyshev
// polynomials of the umbrella operator, so that one iteration costs one visit of all rings.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/fairing/vertex_rings.h"

namespace sline::model {

struct SincFilter {
  int iterations = 60;
  float passBand = 0.05f;  ///< in [0, 2]; waves longer than 2π/acos(1 − passBand) edges are kept
  bool operator==(const SincFilter&) const = default;
};

/// Returns the filtered positions; border vertices stay. Coordinates should be near the origin.
std::vector<glm::vec3> windowedSinc(std::span<const glm::vec3> positions, const VertexRings& rings,
                                    const SincFilter& filter);

/// Returns the coefficients of T_0 … T_n in 1 − k/2, where k ∈ [0, 2] is an eigenvalue of the
/// umbrella operator; their function is 1 at 0 and at least 0.99 … at most 1.01 up to the pass
/// band.
std::vector<double> sincCoefficients(const SincFilter& filter);

/// Returns the positions averaged with a Gaussian's weights of that standard deviation, in edges.
/// Unlike the sinc it leaves no waves beside sharp forms, which lines would follow. Border vertices
/// stay.
std::vector<glm::vec3> gaussian(std::span<const glm::vec3> positions, const VertexRings& rings,
                                float deviation);

/// Returns the values of a surface's vertices averaged likewise, those of borders too.
std::vector<float> gaussian(const std::vector<float>& values, std::span<const glm::vec3> positions,
                            const VertexRings& rings, float deviation);

/// Returns such coefficients of exp(−2σ²k), σ the deviation.
std::vector<double> gaussianCoefficients(float deviation);

/// Replaces each value by the mean over its ring and itself, that many times (borders too).
void averageOverRings(std::vector<float>& values, const VertexRings& rings, int times);
void averageOverRings(std::vector<glm::vec3>& values, const VertexRings& rings, int times);

}  // namespace sline::model
