// SPDX-License-Identifier: Apache-2.0
// Writes small mesh files for the tests, one cube of 8 vertices and 12 triangles in every format,
// and checks a reader's answer.
#pragma once

#include <QByteArray>
#include <QString>
#include <QTemporaryDir>
#include <bit>
#include <span>
#include <vector>

#include "model/import/kinds/file_kinds.h"

namespace sline::test {

/// Holds a mesh file in memory.
struct MeshFile {
  const char* kind;       ///< "ply big endian"
  const char* extension;  ///< ".ply"
  QByteArray bytes;
};

/// Return the unit cube around the origin, normals outward.
std::span<const glm::vec3> cubePositions();
std::span<const model::Triangle> cubeTriangles();

/// Returns the cube in every encoding.
std::vector<MeshFile> cubeFiles();
/// Returns the cube in the encoding of that kind.
QByteArray cubeFile(const char* kind);

/// Appends the value's bytes in that byte order.
template <class T>
void append(QByteArray& bytes, T value, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native)
    std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// Returns a GLB of that JSON and binary chunk.
QByteArray glb(QByteArray json, QByteArray binary);

/// Writes into the folder and reads back by extension.
Result<model::RawMeshes> readBytes(const QTemporaryDir& folder, const QString& name,
                                   const QByteArray& bytes, const model::ReadLimits& limits = {});

std::size_t triangleCount(const model::RawMeshes& read);
std::size_t vertexCount(const model::RawMeshes& read);
/// Returns all warnings in one line.
QString warningText(const model::RawMeshes& read);
/// Tells whether every index is in range, every coordinate is finite and each surface has at least
/// one triangle.
bool isSound(const model::RawMeshes& read);
/// Returns six times the volume enclosed, positive if normals point outward.
double volume(const model::RawMesh& mesh);

}  // namespace sline::test
