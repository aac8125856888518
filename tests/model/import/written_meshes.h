// SPDX-License-Identifier: Apache-2.0
// Writes small meshes to files of every format, for tests of how import reads them.
#pragma once

#include <QString>
#include <QTemporaryDir>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/import/plan/import.h"

namespace sline::test {

/// Returns the extensions of the formats that carry one surface each, without the dot.
std::span<const char* const> meshFormats();

/// Writes the mesh as FOLDER/NAME.FORMAT, with the frame in the format's own header if one is given
/// (glTF: none; the mesh is then taken to be in LPS millimetres and converted to glTF's axes and
/// metres).
void writeMesh(const QString& path, const model::Mesh& mesh,
               std::optional<model::Frame> header = std::nullopt);
void writeText(const QString& path, const QByteArray& text);

/// Returns an octahedron: 6 vertices, 8 triangles, facing outward.
model::MeshPtr octahedron(const glm::vec3& centre, float radius);
/// Returns the surface of the voxels for which `inside` holds (asked at their middles), as squares
/// of two triangles each, facing outward; n³ voxels of 1 mm from the origin.
model::MeshPtr voxelSurface(int n, bool (*inside)(const glm::vec3&));

/// Returns the node of that name; fails the test loudly by returning a node with an empty name.
const model::Node& named(const model::Scene& scene, const std::string& name);
/// Returns all warnings of a report in one line.
QString warningsOf(const model::Imported& imported);

}  // namespace sline::test
