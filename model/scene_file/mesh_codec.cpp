// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/mesh_codec.h"

#include <array>
#include <bit>
#include <cstring>

#include "model/base/number_codes.h"

namespace sline::model {

namespace {
constexpr std::string_view magic = "SlineMe1";
constexpr std::size_t headBytes = 16;

/// Writes unsigned numbers of 32 bits as four planes of bytes, the lowest first.
class PlaneWriter {
 public:
  PlaneWriter(char* at, std::size_t count) : m_at(at), m_count(count) {}
  void put(std::size_t i, std::uint32_t v) {
    for (std::size_t plane = 0; plane < 4; ++plane)
      m_at[plane * m_count + i] = char(v >> (8 * plane) & 0xffu);
  }

 private:
  char* m_at;
  std::size_t m_count;
};

class PlaneReader {
 public:
  PlaneReader(const char* at, std::size_t count) : m_at(at), m_count(count) {}
  std::uint32_t operator[](std::size_t i) const {
    std::uint32_t v = 0;
    for (std::size_t plane = 0; plane < 4; ++plane)
      v |= std::uint32_t(static_cast<unsigned char>(m_at[plane * m_count + i])) << (8 * plane);
    return v;
  }

 private:
  const char* m_at;
  std::size_t m_count;
};

/// Returns a whole number; these have the same order as the floats.
std::uint32_t orderOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return bits ^ (bits >> 31 != 0 ? 0xffffffffu : 0x80000000u);
}
float floatAt(std::uint32_t order) {
  return std::bit_cast<float>(order ^ (order >> 31 != 0 ? 0x80000000u : 0xffffffffu));
}

/// Gives the reference from which a corner's vertex is counted: for the first corner of a triangle
/// the next vertex that no triangle before it has used, for the others the corner before.
class CornerCoder {
 public:
  std::uint32_t reference(int corner) const { return corner == 0 ? m_next : m_last; }
  void pass(std::uint32_t vertex) {
    m_last = vertex;
    if (vertex >= m_next)
      m_next = vertex + 1;
  }

 private:
  std::uint32_t m_next = 0;
  std::uint32_t m_last = 0;
};
}  // namespace

std::string encodedMesh(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertexCount();
  const std::size_t triangles = mesh.triangleCount();
  std::string bytes(headBytes + 12 * (vertices + triangles), '\0');
  std::memcpy(bytes.data(), magic.data(), magic.size());
  putWord(bytes.data() + 8, std::uint32_t(vertices));
  putWord(bytes.data() + 12, std::uint32_t(triangles));
  char* at = bytes.data() + headBytes;
  for (int axis = 0; axis < 3; ++axis, at += 4 * vertices) {
    PlaneWriter planes(at, vertices);
    std::uint32_t last = orderOf(0.0f);
    for (std::size_t i = 0; i < vertices; ++i) {
      const std::uint32_t order = orderOf(mesh.positions()[i][axis]);
      planes.put(i, zigzag(order - last));
      last = order;
    }
  }
  CornerCoder coder;
  std::array<PlaneWriter, 3> corners{PlaneWriter(at, triangles),
                                     PlaneWriter(at + 4 * triangles, triangles),
                                     PlaneWriter(at + 8 * triangles, triangles)};
  for (std::size_t i = 0; i < triangles; ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = mesh.triangles()[i][std::size_t(corner)];
      corners[std::size_t(corner)].put(i, zigzag(vertex - coder.reference(corner)));
      coder.pass(vertex);
    }
  return bytes;
}

Result<Mesh> decodedMesh(std::string_view bytes) {
  if (bytes.size() < headBytes || !bytes.starts_with(magic))
    return Error{.reason = "it is no mesh of this format"};
  const std::size_t vertices = wordAt(bytes, 8);
  const std::size_t triangles = wordAt(bytes, 12);
  const std::size_t promised = headBytes + 12 * (vertices + triangles);
  if (bytes.size() != promised)
    return Error{.reason = "it promises " + std::to_string(promised) + " bytes and has " +
                           std::to_string(bytes.size())};
  std::vector<glm::vec3> positions(vertices);
  const char* at = bytes.data() + headBytes;
  for (int axis = 0; axis < 3; ++axis, at += 4 * vertices) {
    const PlaneReader planes(at, vertices);
    std::uint32_t order = orderOf(0.0f);
    for (std::size_t i = 0; i < vertices; ++i) {
      order += unzigzag(planes[i]);
      positions[i][axis] = floatAt(order);
    }
  }
  std::vector<Triangle> faces(triangles);
  CornerCoder coder;
  const std::array<PlaneReader, 3> corners{PlaneReader(at, triangles),
                                           PlaneReader(at + 4 * triangles, triangles),
                                           PlaneReader(at + 8 * triangles, triangles)};
  for (std::size_t i = 0; i < triangles; ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex =
          coder.reference(corner) + unzigzag(corners[std::size_t(corner)][i]);
      faces[i][std::size_t(corner)] = vertex;
      coder.pass(vertex);
    }
  return Mesh::create(std::move(positions), std::move(faces));
}

}  // namespace sline::model
