// SPDX-License-Identifier: Apache-2.0
#include "model/look/hulls.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/focus/surface_samples.h"
#include "model/geometry/mesh_trees.h"

namespace sline::model {

namespace {

constexpr std::size_t samplesPerMesh = 96;
constexpr double most = 0.6;  // of its samples are inside; tables and headrests lie in no body
constexpr int fewestSides = 5;
// Sides of the hull's box are farther away than this share of the box's diagonal, or it is a copy.
constexpr float apart = 0.002f;

bool liesWithin(const Box& box, const Box& around) {
  const glm::vec3 slack(1e-3f * glm::length(around.high - around.low));
  return glm::all(glm::greaterThanEqual(box.low, around.low - slack)) &&
         glm::all(glm::lessThanEqual(box.high, around.high + slack));
}

/// Tells whether lines from the place meet the hull on all sides but one, none of them at once.
bool isHemmedIn(const Bvh& hull, const glm::vec3& place, float gap) {
  constexpr std::array<glm::vec3, 6> ways{{{1.0f, 0.0f, 0.0f},
                                           {-1.0f, 0.0f, 0.0f},
                                           {0.0f, 1.0f, 0.0f},
                                           {0.0f, -1.0f, 0.0f},
                                           {0.0f, 0.0f, 1.0f},
                                           {0.0f, 0.0f, -1.0f}}};
  int met = 0;
  for (const glm::vec3& way : ways)
    met += hull.blocked({.origin = place, .direction = way});
  return met >= fewestSides && !(hull.closest(place, 0.0f, gap).distance < gap);
}

bool isHull(const MeshPtr& outer, const Mesh& inner) {
  if (!liesWithin(inner.bounds(), outer->bounds()))
    return false;
  const std::vector<SurfaceSample> samples = surfaceSamples(inner, samplesPerMesh);
  if (samples.empty())
    return false;
  const BvhPtr tree = treeOf(outer);
  const float gap = apart * glm::length(outer->bounds().high - outer->bounds().low);
  const auto inside = std::count_if(samples.begin(), samples.end(), [&](const SurfaceSample& each) {
    return isHemmedIn(*tree, each.place, gap);
  });
  return double(inside) >= most * double(samples.size());
}

}  // namespace

std::vector<std::size_t> hullsAmong(const std::vector<MeshPtr>& meshes) {
  std::vector<std::size_t> hulls;
  for (std::size_t outer = 0; outer < meshes.size(); ++outer)
    for (std::size_t inner = 0; inner < meshes.size(); ++inner)
      if (inner != outer && isHull(meshes[outer], *meshes[inner])) {
        hulls.push_back(outer);
        break;
      }
  return hulls;
}

}  // namespace sline::model
