// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/ply_writer.h"

#include <bit>
#include <cassert>
#include <cstdint>

namespace sline::model {

namespace {
void append(std::string& text, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    text += char(value >> shift & 0xffu);
}
}  // namespace

std::string plyText(const Mesh& mesh, const std::string& comment) {
  assert(comment.find('\n') == std::string::npos);
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + comment +
                     "\nelement vertex " + std::to_string(mesh.vertexCount()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangleCount()) +
                     "\nproperty list uchar uint vertex_indices\nend_header\n";
  text.reserve(text.size() + 12 * mesh.vertexCount() + 13 * mesh.triangleCount());
  for (const glm::vec3& p : mesh.positions())
    for (int axis = 0; axis < 3; ++axis)
      append(text, std::bit_cast<std::uint32_t>(p[axis]));
  for (const Triangle& triangle : mesh.triangles()) {
    text += '\3';
    for (const std::uint32_t vertex : triangle)
      append(text, vertex);
  }
  return text;
}

}  // namespace sline::model
