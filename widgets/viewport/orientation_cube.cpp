// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/orientation_cube.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

namespace sline::widgets {

namespace {

/// The face `part` with its letter; seen from outside, `right` × `up` = part, as in the anatomical
/// view of that name.
struct Side {
  char letter;
  glm::ivec3 part;
  glm::ivec3 right;
  glm::ivec3 up;
};
constexpr int sideCount = 6;
const std::array<Side, sideCount>& sides() {
  static const std::array<Side, sideCount> table{{{'A', {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                  {'P', {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                                  {'L', {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                  {'R', {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                                  {'S', {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
                                                  {'I', {0, 0, -1}, {1, 0, 0}, {0, -1, 0}}}};
  return table;
}

const Side& sideOf(const CubeFace& face) {
  for (const Side& side : sides())
    if (side.part == face.part)
      return side;
  return sides().front();
}

/// The part of the way from the middle of a face to its edge beyond which a neighbour is meant,
/// too.
constexpr float inner = 0.56f;

/// Returns the strip of a face, along one of its directions, that belongs to −1, 0 or 1.
glm::vec2 strip(int step) {
  if (step == 0)
    return {-inner, inner};
  return step > 0 ? glm::vec2(inner, 1.0f) : glm::vec2(-1.0f, -inner);
}

}  // namespace

std::array<glm::vec2, 4> CubeFace::corners() const {
  return {centre - right - up, centre + right - up, centre + right + up, centre - right + up};
}

std::string axisOf(const CubeDirection& face) {
  constexpr std::string_view names = "XYZ";
  for (std::size_t axis = 0; axis < names.size(); ++axis)
    if (const int step = face[glm::length_t(axis)]; step != 0)
      return (step < 0 ? "\u2212" : "") + std::string(1, names[axis]);
  return {};
}

std::vector<CubeFace> cubeFaces(const model::Camera& camera, float half) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const auto onScreen = [&](const glm::ivec3& direction) {
    const glm::vec3 d(direction);
    return half * glm::vec2(glm::dot(d, frame.right), -glm::dot(d, frame.up));
  };
  constexpr float edgeOn = 0.02f;
  std::vector<CubeFace> faces;
  for (const Side& side : sides()) {
    const float facing = glm::dot(glm::vec3(side.part), frame.back);
    if (facing > edgeOn)
      faces.push_back({.letter = side.letter,
                       .part = side.part,
                       .centre = onScreen(side.part),
                       .right = onScreen(side.right),
                       .up = onScreen(side.up),
                       .facing = facing});
  }
  return faces;
}

std::vector<std::array<glm::vec2, 4>> cubePatches(const std::vector<CubeFace>& faces,
                                                  const CubeDirection& part) {
  std::vector<std::array<glm::vec2, 4>> patches;
  const auto along = [&](const glm::ivec3& d) {
    return part.x * d.x + part.y * d.y + part.z * d.z;
  };
  for (const CubeFace& face : faces) {
    const Side& side = sideOf(face);
    if (along(side.part) != 1)
      continue;
    const glm::vec2 x = strip(along(side.right));
    const glm::vec2 y = strip(along(side.up));
    const auto at = [&](float a, float b) { return face.centre + a * face.right + b * face.up; };
    patches.push_back({at(x[0], y[0]), at(x[1], y[0]), at(x[1], y[1]), at(x[0], y[1])});
  }
  return patches;
}

std::optional<CubeDirection> cubeDirectionAt(const std::vector<CubeFace>& faces,
                                             const glm::vec2& pixel) {
  for (const CubeFace& face : faces) {
    const glm::vec2 way = pixel - face.centre;
    const float area = face.right.x * face.up.y - face.right.y * face.up.x;
    if (std::abs(area) < 1e-3f)
      continue;
    const float a = (way.x * face.up.y - way.y * face.up.x) / area;
    const float b = (face.right.x * way.y - face.right.y * way.x) / area;
    if (std::abs(a) > 1.0f || std::abs(b) > 1.0f)
      continue;
    const auto step = [](float t) { return t > inner ? 1 : (t < -inner ? -1 : 0); };
    const Side& side = sideOf(face);
    return side.part + step(a) * side.right + step(b) * side.up;
  }
  return std::nullopt;
}

glm::vec3 upwardsFrom(const CubeDirection& part) {
  return part.x == 0 && part.y == 0 ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
}

}  // namespace sline::widgets
