// SPDX-License-Identifier: Apache-2.0
// Estimates the curvature tensor and its derivative at every vertex, after S. Rusinkiewicz,
// "Estimating Curvatures and Their Derivatives on Triangle Meshes" (3DPVT 2004), in the sign
// convention of METHOD §1: convex surfaces with outward normals have positive curvature.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds one entry per vertex. The second principal direction is e2 = n × e1. Curvatures are in
/// 1/mm with |κ1| ≥ |κ2|; the derivative tensor's four numbers, in 1/mm², are C(e1,e1,e1),
/// C(e1,e1,e2), C(e1,e2,e2) and C(e2,e2,e2). Vertices without faces have zero tensors.
struct Curvature {
  std::vector<glm::vec3> e1;
  std::vector<glm::vec2> k;
  std::vector<glm::vec4> derivative;
};

struct CurvatureOptions {
  /// The number of one-ring averaging steps of the tensor before its derivative is taken (METHOD
  /// §5, a choice of style for surfaces from label maps). 0 leaves the estimate as R gives it.
  int smoothingSteps = 0;
};

Curvature curvature(const Mesh& mesh, std::span<const glm::vec3> normals,
                    const CurvatureOptions& options = {});
/// Returns the same of these vertices alone, one entry for each.
Curvature curvatureAt(std::span<const std::uint32_t> vertices, const Mesh& mesh,
                      std::span<const glm::vec3> normals, const CurvatureOptions& options = {});

}  // namespace sline::model
