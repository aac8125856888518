// SPDX-License-Identifier: Apache-2.0
// Writes scenes as other programs write them. All hold the same two kidneys: a tetrahedron without
// symmetry, once in place and once mirrored by its node, in a group.
#pragma once

#include <QByteArray>
#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "model/import/source/raw_mesh.h"

namespace sline::test {

/// Each returns the corners of the kidney or its faces, which seen from outside run
/// counterclockwise.
std::span<const glm::vec3> kidneyPositions();
std::span<const model::Triangle> kidneyTriangles();
/// Returns where the corners of the left kidney are in its scene, 10 to the left, and those of the
/// right one, which mirrors it.
std::array<glm::vec3, 4> leftKidney();
std::array<glm::vec3, 4> rightKidney();

/// Holds the settings of FBX 7.4, with axes by their numbers, as the format counts them: right, up,
/// front.
struct FbxSettings {
  double unitScaleFactor = 1.0;  ///< centimetres
  std::array<int, 3> axes{0, 1, 2};
  std::array<int, 3> signs{1, 1, 1};
};
QByteArray fbxText(const FbxSettings& settings = {});
QByteArray fbxBinary(const FbxSettings& settings = {});

/// Returns COLLADA 1.4; without an asset's unit and axis if these are empty.
QByteArray collada(const QByteArray& metres = "0.01", const QByteArray& upAxis = "Y_UP");

/// Return X3D 3.3 in XML with a unit of one millimetre, and the same scene as VRML97, which has no
/// unit. Lists are separated by commas, and the right kidney uses what the left one defines.
QByteArray x3dXml();
QByteArray vrml();

/// Returns a file of 3D Studio with its vertices in place: no group, no hierarchy; the right
/// kidney's own axes mirror it.
QByteArray threeDs();

/// Returns a scene of Blender 2.79, with a table of only those structures and fields that it needs.
/// Its material is opaque, its colour an amount of light: (1, 0.5, 0.25) is sRGB's (255, 188, 137).
QByteArray blend();

/// Returns one tetrahedron (VTK's cell 10) that is the left kidney, and a line.
QByteArray vtuText();

}  // namespace sline::test
