// SPDX-License-Identifier: Apache-2.0
// Scenes as other programs write them, written by the tests themselves. All hold the same two
// kidneys: a tetrahedron without symmetry, once in place and once mirrored by its node, in a group.
#pragma once

#include <QByteArray>
#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "model/import/source/raw_mesh.h"

namespace sline::test {

/// Corners of the kidney and its faces, seen from outside counterclockwise.
std::span<const glm::vec3> kidneyPositions();
std::span<const model::Triangle> kidneyTriangles();
/// Where the corners of the left kidney are in its scene, 10 to the left, and of the right one,
/// which mirrors it.
std::array<glm::vec3, 4> leftKidney();
std::array<glm::vec3, 4> rightKidney();

/// FBX 7.4. Axes by their numbers, as the format counts them: right, up, front.
struct FbxSettings {
  double unitScaleFactor = 1.0;  ///< centimetres
  std::array<int, 3> axes{0, 1, 2};
  std::array<int, 3> signs{1, 1, 1};
};
QByteArray fbxText(const FbxSettings& settings = {});
QByteArray fbxBinary(const FbxSettings& settings = {});

/// COLLADA 1.4; without an asset's unit and axis where these are empty.
QByteArray collada(const QByteArray& metres = "0.01", const QByteArray& upAxis = "Y_UP");

/// X3D 3.3 in XML, a unit one millimetre, and the same as VRML97, which has no unit. Lists are
/// parted by commas, and the right kidney uses what the left one defines.
QByteArray x3dXml();
QByteArray vrml();

/// 3D Studio's, its vertices in place: no group, no hierarchy; the right kidney's own axes mirror
/// it.
QByteArray threeDs();

/// A scene of Blender 2.79, with a table of only those structures and fields that it needs. Its
/// material is opaque, its colour an amount of light: (1, 0.5, 0.25) is sRGB's (255, 188, 137).
QByteArray blend();

/// One tetrahedron (VTK's cell 10) that is the left kidney, a line besides.
QByteArray vtuText();

}  // namespace sline::test
