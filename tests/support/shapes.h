// SPDX-License-Identifier: Apache-2.0
// Makes surfaces of which curvature and contours are known in closed form, with outward normals, in
// millimetres.
#pragma once

#include <cstdint>

#include "model/geometry/mesh.h"

namespace sline::test {

/// Returns an icosphere with 20·4^levels faces around the origin.
model::MeshPtr sphere(float radius, int levels);
/// Returns a torus around z: ring radius `major`, tube radius `minor`, 2·aroundRing·aroundTube
/// faces.
model::MeshPtr torus(float major, float minor, int aroundRing, int aroundTube);
/// Returns an open tube around z from −height/2 to height/2.
model::MeshPtr cylinder(float radius, float height, int around, int along);
/// Returns z = (a·x² + b·y²)/2 over [−size, size]², open; normals point to +z.
model::MeshPtr paraboloid(float a, float b, float size, int cells);
/// Moves every vertex within the surface's tangent plane, evenly distributed over a disc with a
/// radius of `fraction` of the shortest edge there, then back onto the surface with `project`.
model::MeshPtr jittered(const model::Mesh& mesh, float fraction, std::uint32_t seed,
                        glm::vec3 (*project)(const glm::vec3&));
/// Returns the mesh mirrored at x = 0, with triangles turned so that normals stay outward.
model::MeshPtr mirrored(const model::Mesh& mesh);
/// Returns both in one mesh, nothing joined.
model::MeshPtr together(const model::Mesh& a, const model::Mesh& b);
/// Returns the mesh turned about an arbitrary axis, so that a symmetric shape and its mirror image
/// are not alike: between two strokes that are each other's image chance decides.
model::MeshPtr askew(const model::Mesh& mesh);
model::MeshPtr moved(const model::Mesh& mesh, float scale, const glm::vec3& offset);

}  // namespace sline::test
