// SPDX-License-Identifier: Apache-2.0
// Builds the binary part of a GLB file and the tables that tell where everything lies in it (glTF
// 2.0 §3.6).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "model/geometry/mesh.h"
#include "render/export/gltf/gltf_json.h"

namespace sline::render {

/// Holds indices of accessors.
struct GltfSurface {
  int positions = 0;
  int normals = 0;
  int indices = 0;
};

class GltfBuffer {
 public:
  /// Returns the bytes that the surface of such a mesh takes.
  static double bytesOf(const model::Mesh& mesh);
  /// Returns the surface of a mesh with triangles; structures that share a mesh share it here too.
  const GltfSurface& surfaceOf(const model::MeshPtr& mesh);

  /// Adds a number for each vertex of a mesh; returns the accessor's index.
  int numbers(std::span<const float> values);

  const Json& accessors() const { return m_accessors; }
  const Json& views() const { return m_views; }
  /// Returns the bytes, little-endian; their length is a multiple of 4.
  const std::string& bytes() const { return m_bytes; }

 private:
  int points(std::span<const glm::vec3> values, bool withBounds);
  int triangles(const model::Mesh& mesh);
  int accessor(Json described);
  /// Begins a view at the end of the bytes; `close` ends it.
  int open(int target);
  void close();

  Json m_accessors = Json::array();
  Json m_views = Json::array();
  std::string m_bytes;
  std::map<model::MeshPtr, GltfSurface> m_surfaces;
};

}  // namespace sline::render
