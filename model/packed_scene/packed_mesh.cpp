// SPDX-License-Identifier: Apache-2.0
#include "model/packed_scene/packed_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <span>

#include "model/base/number_codes.h"
#include "model/packed_scene/byte_stream.h"
#include "model/packed_scene/mesh_walk.h"

namespace sline::model {

namespace {

using packing::ByteReader;
using packing::ByteWriter;
using packing::Edge;
using packing::Expected;
using packing::Recent;

constexpr std::string_view meshMagic = "SlPM";
constexpr float steps = 65535.0f;
constexpr std::size_t planes = 3;  // bytes of a difference
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Finds triangles that are still to be listed, by an edge of theirs.
class OpenTriangles {
 public:
  explicit OpenTriangles(std::span<const Triangle> triangles)
      : m_triangles(triangles), m_listed(triangles.size(), false) {
    m_sides.reserve(3 * triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::uint8_t corner = 0; corner < 3; ++corner)
        m_sides.push_back(
            {triangles[i][corner], triangles[i][(corner + 1u) % 3u], std::uint32_t(i), corner});
    std::sort(m_sides.begin(), m_sides.end());
    m_passed.resize(m_sides.size(), 0);
  }

  PackedMesh::Place across(std::uint32_t from, std::uint32_t to) {
    const auto begin = std::lower_bound(m_sides.begin(), m_sides.end(), Side{from, to, 0, 0});
    if (begin == m_sides.end())
      return {none, 0};
    // What is listed stays so: the sides of very many triangles at one edge are passed once.
    std::uint32_t& passed = m_passed[std::size_t(begin - m_sides.begin())];
    for (auto side = begin + passed; side != m_sides.end() && side->from == from && side->to == to;
         ++side, ++passed)
      if (!m_listed[side->triangle])
        return {side->triangle, side->corner};
    return {none, 0};
  }
  /// Returns the first of those that are left; `none` where there are none.
  std::uint32_t first() {
    while (m_first < m_listed.size() && m_listed[m_first])
      ++m_first;
    return m_first < m_listed.size() ? std::uint32_t(m_first) : none;
  }
  void list(std::uint32_t triangle) { m_listed[triangle] = true; }
  const Triangle& operator[](std::uint32_t triangle) const { return m_triangles[triangle]; }

 private:
  struct Side {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t triangle = 0;
    std::uint8_t corner = 0;
    auto operator<=>(const Side&) const = default;
  };
  std::span<const Triangle> m_triangles;
  std::vector<bool> m_listed;
  std::vector<Side> m_sides;
  std::vector<std::uint32_t> m_passed;  ///< at the first side of an edge: how many are listed
  std::size_t m_first = 0;
};

class MeshPacker {
 public:
  explicit MeshPacker(const Mesh& mesh)
      : m_mesh(mesh), m_open(mesh.triangles()), m_numbers(mesh.vertexCount(), none) {
    const Box bounds =
        mesh.bounds().empty() ? Box{glm::vec3(0.0f), glm::vec3(0.0f)} : mesh.bounds();
    // The side of a box of floats may be longer than a float, and a step shorter than one.
    const glm::dvec3 size = glm::dvec3(bounds.high) - glm::dvec3(bounds.low);
    const double side = std::max(size.x, std::max(size.y, size.z));
    m_origin = bounds.low;
    m_step = side > 0.0 ? std::max(float(side / double(steps)), std::numeric_limits<float>::min())
                        : 1.0f;
    m_packed.places.resize(mesh.triangleCount());
  }

  PackedMesh pack() {
    while (m_listed < m_mesh.triangleCount())
      if (!follow())
        begin();
    ByteWriter out;
    out.raw(meshMagic);
    out.word(std::uint32_t(m_mesh.triangleCount()));
    out.word(std::uint32_t(m_at.size()));
    for (int axis = 0; axis < 3; ++axis)
      out.real(m_origin[axis]);
    out.real(m_step);
    out.block(m_far);
    out.raw(m_codes);
    for (std::size_t plane = 0; plane < planes; ++plane)
      for (int axis = 0; axis < 3; ++axis)
        for (const glm::uvec3& d : m_differences)
          m_plane += char(d[axis] >> (8 * plane) & 0xffu);
    out.raw(m_plane);
    m_packed.bytes = out.take();
    return std::move(m_packed);
  }

 private:
  void place(std::uint32_t triangle, std::uint8_t first) {
    m_packed.places[triangle] = {std::uint32_t(m_listed++), first};
    m_open.list(triangle);
  }

  /// Gives the vertex the next number.
  void enter(std::uint32_t vertex, const glm::ivec3& expected) {
    m_numbers[vertex] = std::uint32_t(m_at.size());
    const glm::vec3 exact = (m_mesh.positions()[vertex] - m_origin) / m_step;
    const glm::ivec3 at = glm::ivec3(glm::round(glm::clamp(exact, 0.0f, steps)));
    m_packed.vertices.push_back(vertex);
    m_at.push_back(at);
    glm::uvec3 difference{};
    for (int axis = 0; axis < 3; ++axis)
      difference[axis] = zigzag(std::uint32_t(at[axis] - expected[axis]));
    m_differences.push_back(difference);
  }

  /// Lists a triangle at one of the newest edges; returns false where there is none.
  bool follow() {
    for (unsigned back = 0; back < m_recent.edges(); ++back) {
      const Edge edge = m_recent.edge(back);
      const PackedMesh::Place next =
          m_open.across(m_packed.vertices[edge.from], m_packed.vertices[edge.to]);
      if (next.triangle == none)
        continue;
      const std::uint32_t vertex = m_open[next.triangle][(next.first + 2u) % 3u];
      place(next.triangle, next.first);
      const unsigned code = third(vertex, Expected::across(edge, m_at));
      m_codes += char(back << 4 | code);
      m_recent.addTriangle({edge.from, edge.to, m_numbers[vertex]}, false);
      return true;
    }
    return false;
  }

  /// Lists the first triangle that is left, by its three vertices.
  void begin() {
    const std::uint32_t triangle = m_open.first();
    place(triangle, 0);
    m_codes += char(packing::noEdge << 4);
    Triangle numbers{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = m_open[triangle][corner];
      // 0: the next number; else how far back it is.
      const bool fresh = m_numbers[vertex] == none;
      packing::putShort(m_far, fresh ? 0 : std::uint32_t(m_at.size()) - m_numbers[vertex]);
      if (fresh)
        enter(vertex, Expected::after(m_at));
      numbers[corner] = m_numbers[vertex];
      m_recent.addVertex(numbers[corner]);
    }
    m_recent.addTriangle(numbers, true);
  }

  /// Says which vertex is the third, and returns its code.
  unsigned third(std::uint32_t vertex, const glm::ivec3& expected) {
    const std::uint32_t number = m_numbers[vertex];
    if (number == none) {
      enter(vertex, expected);
      m_recent.addVertex(m_numbers[vertex]);
      return packing::newVertex;
    }
    for (unsigned back = 0; back < m_recent.vertices(); ++back)
      if (m_recent.vertex(back) == number)
        return back + 1;
    packing::putShort(m_far, std::uint32_t(m_at.size()) - number);
    m_recent.addVertex(number);
    return packing::farVertex;
  }

  const Mesh& m_mesh;
  OpenTriangles m_open;
  Recent m_recent;
  PackedMesh m_packed;
  std::vector<std::uint32_t> m_numbers;  ///< of the mesh's vertices; `none`: not yet used
  std::vector<glm::ivec3> m_at;
  std::vector<glm::uvec3> m_differences;
  std::string m_codes;
  std::string m_far;
  std::string m_plane;
  glm::vec3 m_origin{0.0f};
  float m_step = 1.0f;
  std::size_t m_listed = 0;
};

class MeshUnpacker {
 public:
  explicit MeshUnpacker(std::string_view bytes) : m_in(bytes), m_length(bytes.size()) {}

  Result<Mesh> unpack() {
    if (m_in.raw(meshMagic.size()) != meshMagic)
      return Error{.reason = "these bytes hold no packed mesh"};
    const std::size_t triangles = m_in.word();
    m_vertices = m_in.word();
    if (triangles > m_length || m_vertices > m_length)  // each takes bytes
      return Error{.reason = "the packed mesh is cut short"};
    glm::vec3 origin{0.0f};
    for (int axis = 0; axis < 3; ++axis)
      origin[axis] = m_in.real();
    const float step = m_in.real();
    m_far = ByteReader(m_in.block());
    const std::string_view codes = m_in.raw(triangles);
    m_planes = m_in.raw(3 * planes * m_vertices);
    if (m_in.failed() || !m_in.atEnd())
      return Error{.reason = "the packed mesh is cut short or has something after it"};
    m_at.reserve(m_vertices);
    m_triangles.reserve(triangles);
    for (const char code : codes)
      if (!take(static_cast<unsigned char>(code)))
        return Error{.reason = "triangle " + std::to_string(m_triangles.size()) +
                               " of the packed mesh makes no sense"};
    if (m_at.size() != m_vertices)
      return Error{.reason = "the packed mesh has vertices that no triangle uses"};
    std::vector<glm::vec3> positions;
    positions.reserve(m_at.size());
    constexpr float most = std::numeric_limits<float>::max();
    for (const glm::ivec3& at : m_at)
      positions.push_back(glm::clamp(origin + step * glm::vec3(at), -most, most));
    return Mesh::create(std::move(positions), std::move(m_triangles));
  }

 private:
  bool take(unsigned code) {
    const unsigned back = code >> 4;
    if (back == packing::noEdge)
      return begin();
    if (back >= m_recent.edges())
      return false;
    const Edge edge = m_recent.edge(back);
    const std::optional<std::uint32_t> third = this->third(code & 15u, edge);
    if (!third)
      return false;
    m_triangles.push_back({edge.from, edge.to, *third});
    m_recent.addTriangle(m_triangles.back(), false);
    return true;
  }

  bool begin() {
    Triangle numbers{};
    for (std::uint32_t& number : numbers) {
      const std::uint32_t back = m_far.shortWord();
      if (m_far.failed() || back > m_at.size() || (back == 0 && !enter(Expected::after(m_at))))
        return false;
      number = back == 0 ? std::uint32_t(m_at.size() - 1) : std::uint32_t(m_at.size()) - back;
      m_recent.addVertex(number);
    }
    m_triangles.push_back(numbers);
    m_recent.addTriangle(numbers, true);
    return true;
  }

  std::optional<std::uint32_t> third(unsigned code, const Edge& edge) {
    if (code == packing::newVertex) {
      if (!enter(Expected::across(edge, m_at)))
        return std::nullopt;
      m_recent.addVertex(std::uint32_t(m_at.size() - 1));
      return std::uint32_t(m_at.size() - 1);
    }
    if (code != packing::farVertex)
      return code <= m_recent.vertices() ? std::optional(m_recent.vertex(code - 1)) : std::nullopt;
    const std::uint32_t back = m_far.shortWord();
    if (m_far.failed() || back == 0 || back > m_at.size())
      return std::nullopt;
    const std::uint32_t number = std::uint32_t(m_at.size()) - back;
    m_recent.addVertex(number);
    return number;
  }

  /// Adds the next vertex; returns false where there are no more.
  bool enter(const glm::ivec3& expected) {
    const std::size_t i = m_at.size();
    if (i == m_vertices)
      return false;
    glm::ivec3 at{};
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t code = 0;
      for (std::size_t plane = 0; plane < planes; ++plane)
        code |= std::uint32_t(static_cast<unsigned char>(
                    m_planes[(3 * plane + std::size_t(axis)) * m_vertices + i]))
                << (8 * plane);
      at[axis] = expected[axis] + std::int32_t(unzigzag(code));
      if (at[axis] < 0 || at[axis] > int(steps))
        return false;
    }
    m_at.push_back(at);
    return true;
  }

  ByteReader m_in;
  std::size_t m_length;
  ByteReader m_far{{}};
  Recent m_recent;
  std::size_t m_vertices = 0;
  std::string_view m_planes;
  std::vector<glm::ivec3> m_at;
  std::vector<Triangle> m_triangles;
};

}  // namespace

PackedMesh packedMesh(const Mesh& mesh) {
  return MeshPacker(mesh).pack();
}

Result<Mesh> unpackedMesh(std::string_view bytes) {
  return MeshUnpacker(bytes).unpack();
}

}  // namespace sline::model
