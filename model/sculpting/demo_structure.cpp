// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/demo_structure.h"

#include <algorithm>
#include <cassert>
#include <glm/vector_relational.hpp>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "model/base/parallel.h"
#include "model/geometry/topology.h"
#include "model/sculpting/polygonise.h"
#include "model/sculpting/sampled_field.h"
#include "model/sculpting/stopping.h"

namespace sline::model {

namespace {
/// The most that `folds` may add to a wall, in mm.
constexpr float deepestFold = 3.0f;

struct Cutter {
  const Field* field = nullptr;
  Box reach;  ///< outside this box the cut has no effect
};

/// Returns how far from a neighbour the structure's shape may depend on it: an inner surface
/// follows a dent of the outer one, and smoothing looks around.
float feltWithin(const DemoStructure& own) {
  return own.gap + 2.0f * own.rounding + 2.0f * own.wall + 5.0f * own.smoothing;
}

/// Returns the structure's own field minus its neighbours. Far from a neighbour the distance to its
/// box replaces the distance to the neighbour itself: it is never larger, and the sign is the same.
Field cutField(const DemoStructure& own, std::vector<Cutter> cutters) {
  if (cutters.empty())
    return own.field;
  const float margin = feltWithin(own);
  return [&own, cutters = std::move(cutters), margin](const glm::vec3& p) {
    float d = own.field(p);
    for (const Cutter& cutter : cutters) {
      const float outside = distanceToBox(cutter.reach, p);
      d = outside > 0.0f ? std::max(d, -(outside + margin - own.gap))
                         : blendedDifference(d, (*cutter.field)(p)-own.gap, own.rounding);
    }
    return d;
  };
}

/// Returns the cut field within `reach` of a place, without the cutters that have no effect there.
Field localCutField(const DemoStructure& own, const std::vector<Cutter>& cutters,
                    const glm::vec3& place, float reach) {
  const float margin = feltWithin(own);
  std::vector<Cutter> felt;
  for (const Cutter& cutter : cutters)
    if (distanceToBox(cutter.reach, place) <= reach && (*cutter.field)(place) <= reach + margin)
      felt.push_back(cutter);
  return [field = cutField(own, std::move(felt)), least = own.gap - margin](const glm::vec3& p) {
    return std::max(field(p), least);
  };
}

Field hollowed(const DemoStructure& own, Field solid) {
  if (!own.opening)
    return solid;
  return [&own, solid = std::move(solid)](const glm::vec3& p) {
    float d = solid(p);
    if (own.wall > 0.0f)
      d = blendedDifference(d, d + own.wall, own.rounding);
    return blendedDifference(d, own.opening(p), own.rounding);
  };
}

const DemoStructure* named(const std::vector<DemoStructure>& structures, const std::string& name) {
  const auto at = std::find_if(structures.begin(), structures.end(),
                               [&](const DemoStructure& s) { return s.name == name; });
  return at == structures.end() ? nullptr : &*at;
}

Field smoothed(const DemoStructure& own, const std::vector<Cutter>& cutters) {
  const auto local = [&](const glm::vec3& place, float reach) {
    return localCutField(own, cutters, place, reach);
  };
  // Samples no farther apart than the smoothing leave no trace of their lattice. A cavity's surface
  // lies well within the body.
  const float depth = own.wall + (own.folds ? deepestFold : 0.0f);
  const SampledField::Fineness fineness{own.smoothing, own.smoothing, depth};
  const auto samples =
      std::make_shared<const SampledField>(local, grown(own.box, 3.0f * own.smoothing), fineness);
  return [samples](const glm::vec3& p) { return samples->distance(p); };
}

Field cutField(const DemoStructure& own, const std::vector<DemoStructure>& all) {
  std::vector<Cutter> cutters;
  for (const std::string& name : own.givesWayTo) {
    const DemoStructure* other = named(all, name);
    assert(other && other != &own);
    const Box reach = grown(other->box, feltWithin(own));
    if (meet(reach, own.box))
      cutters.push_back({&other->field, reach});
  }
  return own.smoothing > 0.0f ? smoothed(own, cutters) : cutField(own, std::move(cutters));
}

/// Returns the component with the most triangles, since cutting may leave crumbs.
MeshPtr largestComponent(const MeshPtr& mesh) {
  const Components components = connectedComponents(*mesh);
  if (components.count <= 1)
    return mesh;
  std::vector<std::size_t> sizes(components.count, 0);
  for (const std::uint32_t c : components.ofTriangle)
    ++sizes[c];
  const auto largest = std::uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<std::uint32_t> newIndex(mesh->vertexCount(), 0);
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < mesh->triangleCount(); ++t) {
    if (components.ofTriangle[t] != largest)
      continue;
    Triangle kept = mesh->triangles()[t];
    for (std::uint32_t& v : kept) {
      if (newIndex[v] == 0) {
        positions.push_back(mesh->positions()[v]);
        newIndex[v] = std::uint32_t(positions.size());
      }
      v = newIndex[v] - 1;
    }
    triangles.push_back(kept);
  }
  return std::make_shared<const Mesh>(
      Mesh::create(std::move(positions), std::move(triangles)).value());
}

/// Joins both surfaces into one mesh, with the second turned inside out.
MeshPtr withCavity(const Mesh& outer, const Mesh& cavity) {
  std::vector<glm::vec3> positions(outer.positions().begin(), outer.positions().end());
  std::vector<Triangle> triangles(outer.triangles().begin(), outer.triangles().end());
  const auto first = std::uint32_t(positions.size());
  positions.insert(positions.end(), cavity.positions().begin(), cavity.positions().end());
  for (const auto& [a, b, c] : cavity.triangles())
    triangles.push_back({first + a, first + c, first + b});
  return std::make_shared<const Mesh>(
      Mesh::create(std::move(positions), std::move(triangles)).value());
}

MeshPtr meshed(const DemoStructure& own, const std::vector<DemoStructure>& all) {
  const Field solid = cutField(own, all);
  const auto mesh = [&own](const Field& body, float edge) {
    if (own.mesher)
      return own.mesher(body, edge);
    return largestComponent(own.pattern ? fitted(*own.pattern, body, edge)
                                        : polygonise(body, own.box, edge));
  };
  MeshPtr outer = mesh(hollowed(own, solid), own.edge);
  if (own.wall <= 0.0f || own.opening)
    return outer;
  assert(!own.pattern);
  const Field cavity = [&own, &solid](const glm::vec3& p) {
    return solid(p) + own.wall + (own.folds ? own.folds(p) : 0.0f);
  };
  // The cavity is seen only where the body is cut open.
  constexpr float coarser = 1.6f;
  return withCavity(*outer, *mesh(cavity, coarser * own.edge));
}

[[maybe_unused]] bool namesAreUnique(const std::vector<DemoStructure>& structures) {
  std::vector<std::string> names;
  names.reserve(structures.size());
  for (const DemoStructure& s : structures)
    names.push_back(s.name);
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) == names.end();
}

/// Returns the group at the end of the path and makes it and the groups above it where they are
/// missing.
NodeId groupAt(Scene& scene, std::map<std::vector<std::string>, NodeId>& known,
               const std::vector<std::string>& path) {
  if (path.empty())
    return rootId;
  const auto found = known.find(path);
  if (found != known.end())
    return found->second;
  const NodeId parent = groupAt(scene, known, {path.begin(), path.end() - 1});
  const NodeId made = scene.append({.parent = parent, .name = path.back()});
  known.emplace(path, made);
  return made;
}
}  // namespace

Scene demoScene(std::vector<DemoStructure> structures, const std::stop_token& stop) {
  for (DemoStructure& s : structures)
    s.field = stoppable(std::move(s.field), stop);
  assert(namesAreUnique(structures));
  std::vector<MeshPtr> meshes(structures.size());
  // The largest come first, so that none of them is left to run alone at the end.
  std::vector<std::size_t> order(structures.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto work = [&](std::size_t i) {
    const glm::vec3 size = structures[i].box.size() / structures[i].edge;
    return size.x * size.y * size.z;
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return work(a) > work(b); });
  parallelFor(order.size(), 1, [&](std::size_t k) {
    // An exception out of this loop would also abort unrelated work of VTK, whose loops nest in it,
    // and VTK would not notice.
    try {
      meshes[order[k]] = meshed(structures[order[k]], structures);
    } catch (const ModellingStopped&) {
      return;
    }
  });
  goOnUnless(stop);

  Scene scene;
  std::map<std::vector<std::string>, NodeId> groups;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const DemoStructure& s = structures[i];
    scene.append(
        {.parent = groupAt(scene, groups, s.groups),
         .name = s.name,
         .style = {.colour = s.colour, .inkColour = s.inkColour, .gamma = s.gamma, .fill = s.fill},
         .mesh = std::move(meshes[i]),
         .provenance = {.frame = "LPS", .frameReason = "modelled in it"}});
  }
  return scene;
}

}  // namespace sline::model
