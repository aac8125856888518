// SPDX-License-Identifier: Apache-2.0
#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numbers>
#include <random>

#include "model/geometry/normals.h"

namespace sline::test {

using model::Mesh;
using model::MeshPtr;
using model::Triangle;

namespace {
constexpr float pi = std::numbers::pi_v<float>;

MeshPtr build(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  return std::make_shared<const Mesh>(
      std::move(Mesh::create(std::move(positions), std::move(triangles))).value());
}

struct Icosahedron {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

Icosahedron icosahedron() {
  const float g = (1.0f + std::sqrt(5.0f)) / 2.0f;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

void quad(std::vector<Triangle>& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c,
          std::uint32_t d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}
}  // namespace

MeshPtr sphere(float radius, int levels) {
  Icosahedron s = icosahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] =
          middles.try_emplace(std::minmax(a, b), std::uint32_t(s.positions.size()));
      if (fresh)
        s.positions.push_back(0.5f * (s.positions[a] + s.positions[b]));
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
    for (glm::vec3& p : s.positions)
      p = glm::normalize(p);
  }
  for (glm::vec3& p : s.positions)
    p = radius * glm::normalize(p);
  return build(std::move(s.positions), std::move(s.triangles));
}

MeshPtr torus(float major, float minor, int aroundRing, int aroundTube) {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  for (int i = 0; i < aroundRing; ++i)
    for (int j = 0; j < aroundTube; ++j) {
      const float u = 2.0f * pi * float(i) / float(aroundRing);
      const float v = 2.0f * pi * float(j) / float(aroundTube);
      const float r = major + minor * std::cos(v);
      positions.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    }
  const auto at = [&](int i, int j) {
    return std::uint32_t((i % aroundRing) * aroundTube + j % aroundTube);
  };
  for (int i = 0; i < aroundRing; ++i)
    for (int j = 0; j < aroundTube; ++j)
      quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return build(std::move(positions), std::move(triangles));
}

MeshPtr cylinder(float radius, float height, int around, int along) {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= along; ++j) {
      const float u = 2.0f * pi * float(i) / float(around);
      positions.emplace_back(radius * std::cos(u), radius * std::sin(u),
                             height * (float(j) / float(along) - 0.5f));
    }
  const auto at = [&](int i, int j) { return std::uint32_t((i % around) * (along + 1) + j); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < along; ++j)
      quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return build(std::move(positions), std::move(triangles));
}

MeshPtr paraboloid(float a, float b, float size, int cells) {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const float x = size * (2.0f * float(i) / float(cells) - 1.0f);
      const float y = size * (2.0f * float(j) / float(cells) - 1.0f);
      positions.emplace_back(x, y, 0.5f * (a * x * x + b * y * y));
    }
  const auto at = [&](int i, int j) { return std::uint32_t(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return build(std::move(positions), std::move(triangles));
}

MeshPtr jittered(const Mesh& mesh, float fraction, std::uint32_t seed,
                 glm::vec3 (*project)(const glm::vec3&)) {
  const auto points = mesh.positions();
  std::vector<float> reach(mesh.vertexCount(), std::numeric_limits<float>::infinity());
  for (const Triangle& t : mesh.triangles())
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c];
      const std::uint32_t b = t[(c + 1) % 3];
      const float edge = fraction * glm::distance(points[a], points[b]);
      reach[a] = std::min(reach[a], edge);
      reach[b] = std::min(reach[b], edge);
    }
  const std::vector<glm::vec3> normals = model::vertexNormals(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<glm::vec3> positions(points.begin(), points.end());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3 n = normals[i];
    const glm::vec3 other = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 s = glm::normalize(glm::cross(n, other));
    const float angle = 2.0f * pi * unit(random);
    const float length = reach[i] * std::sqrt(unit(random));
    positions[i] =
        project(positions[i] + length * (std::cos(angle) * s + std::sin(angle) * glm::cross(n, s)));
  }
  return build(std::move(positions), {mesh.triangles().begin(), mesh.triangles().end()});
}

MeshPtr mirrored(const Mesh& mesh) {
  std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  for (glm::vec3& p : positions)
    p.x = -p.x;
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (Triangle& t : triangles)
    std::swap(t[1], t[2]);
  return build(std::move(positions), std::move(triangles));
}

MeshPtr together(const Mesh& a, const Mesh& b) {
  std::vector<glm::vec3> positions(a.positions().begin(), a.positions().end());
  positions.insert(positions.end(), b.positions().begin(), b.positions().end());
  std::vector<Triangle> triangles(a.triangles().begin(), a.triangles().end());
  const auto first = std::uint32_t(a.vertexCount());
  for (const Triangle& t : b.triangles())
    triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return build(std::move(positions), std::move(triangles));
}

MeshPtr moved(const Mesh& mesh, float scale, const glm::vec3& offset) {
  std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  for (glm::vec3& p : positions)
    p = scale * p + offset;
  return build(std::move(positions), {mesh.triangles().begin(), mesh.triangles().end()});
}

MeshPtr askew(const Mesh& mesh) {
  const glm::mat3 turn(glm::rotate(glm::mat4(1.0f), 0.4f, glm::normalize(glm::vec3(1, 2, 3))));
  std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  for (glm::vec3& p : positions)
    p = turn * p;
  return build(std::move(positions), {mesh.triangles().begin(), mesh.triangles().end()});
}

}  // namespace sline::test
