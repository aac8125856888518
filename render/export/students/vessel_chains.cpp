// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/vessel_chains.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "model/anatomy/body_systems.h"
#include "model/focus/tissues.h"
#include "model/geometry/mesh_trees.h"

namespace sline::render {

namespace {

constexpr std::size_t shortest = 3;
constexpr std::size_t longest = 12;
/// Surfaces of neighbours that were segmented apart end a voxel or two from each other, mm.
constexpr float touching = 2.0f;
constexpr std::size_t mostProbes = 4000;

bool areApart(const model::Box& a, const model::Box& b) {
  const auto apart = [](float highA, float lowA, float highB, float lowB) {
    return lowA - highB > touching || lowB - highA > touching;
  };
  return apart(a.high.x, a.low.x, b.high.x, b.low.x) ||
         apart(a.high.y, a.low.y, b.high.y, b.low.y) || apart(a.high.z, a.low.z, b.high.z, b.low.z);
}

/// Returns the middle of where the first touches the other; nothing where they are apart.
std::optional<glm::vec3> contact(const model::MeshPtr& a, const model::MeshPtr& b,
                                 model::MeshTrees& trees) {
  if (areApart(a->bounds(), b->bounds()))
    return std::nullopt;
  const model::Bvh& tree = trees.of(b);
  const auto& places = a->positions();
  const std::size_t step = std::max<std::size_t>(1, places.size() / mostProbes);
  glm::vec3 sum{0.0f};
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); i += step)
    if (tree.isWithin(places[i], touching)) {
      sum += places[i];
      ++count;
    }
  return count == 0 ? std::nullopt : std::optional(sum / float(count));
}

float lengthOf(const model::Mesh& mesh) {
  const model::Box box = mesh.bounds();
  return glm::distance(box.low, box.high);
}

/// Returns how wide a tube is: its surface's area through its length, which is about its box's
/// diagonal.
float widthOf(const model::Mesh& mesh) {
  double area = 0.0;
  for (const model::Triangle& t : mesh.triangles()) {
    const auto& p = mesh.positions();
    area += 0.5 * double(glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
  }
  return float(area) / std::max(lengthOf(mesh), 1e-6f);
}

class ChainFinder {
 public:
  explicit ChainFinder(const model::Scene& scene)
      : m_scene(scene), m_tissues(model::tissuesOf(scene)) {}

  std::vector<model::NodeId> chainIn(model::NodeId group) {
    const std::vector<model::NodeId> members = m_scene.children(group);
    if (members.size() < shortest || members.size() > longest ||
        !std::all_of(members.begin(), members.end(),
                     [this](model::NodeId id) { return isShownVessel(id); }))
      return {};
    return inFlow(path(members));
  }

 private:
  bool isShownVessel(model::NodeId id) const {
    const model::Node& node = *m_scene.find(id);
    const auto tissue = m_tissues.find(id.value);
    return !node.isGroup() && node.mesh->triangleCount() > 0 && m_scene.resolve(id).visible &&
           tissue != m_tissues.end() && tissue->second == model::Tissue::vessel;
  }

  /// A member that another touches, and where.
  struct Neighbour {
    std::size_t member;
    glm::vec3 place;
  };

  std::vector<std::vector<Neighbour>> neighboursOf(const std::vector<model::NodeId>& members) {
    std::vector<std::vector<Neighbour>> beside(members.size());
    for (std::size_t a = 0; a < members.size(); ++a)
      for (std::size_t b = 0; b < members.size(); ++b)
        if (a != b)
          if (const auto place =
                  contact(m_scene.find(members[a])->mesh, m_scene.find(members[b])->mesh, m_trees))
            beside[a].push_back({b, *place});
    return beside;
  }

  /// Tells whether the vessel ends at the one neighbour, or runs from one to the other: two that
  /// meet it at the same end are branches.
  bool runsBetween(model::NodeId vessel, const std::vector<Neighbour>& neighbours) const {
    return neighbours.size() == 1 ||
           (neighbours.size() == 2 && glm::distance(neighbours[0].place, neighbours[1].place) >
                                          0.5f * lengthOf(*m_scene.find(vessel)->mesh));
  }

  /// Returns the members in a path along which each touches the next, and no others do; else
  /// nothing.
  std::vector<model::NodeId> path(const std::vector<model::NodeId>& members) {
    const std::vector<std::vector<Neighbour>> beside = neighboursOf(members);
    std::size_t at = 0;
    while (at < members.size() && beside[at].size() != 1)
      ++at;
    std::vector<model::NodeId> found;
    std::size_t before = members.size();
    while (at < members.size()) {
      if (found.size() == members.size() || !runsBetween(members[at], beside[at]))
        return {};
      found.push_back(members[at]);
      const auto next = std::find_if(beside[at].begin(), beside[at].end(),
                                     [before](const Neighbour& n) { return n.member != before; });
      before = at;
      at = next == beside[at].end() ? members.size() : next->member;
    }
    return found.size() == members.size() ? found : std::vector<model::NodeId>();
  }

  std::vector<model::NodeId> inFlow(std::vector<model::NodeId> vessels) const {
    if (vessels.empty())
      return vessels;
    const bool narrowFirst = widthOf(*m_scene.find(vessels.front())->mesh) <
                             widthOf(*m_scene.find(vessels.back())->mesh);
    if (narrowFirst != isVein(vessels.front()))
      std::reverse(vessels.begin(), vessels.end());
    return vessels;
  }

  bool isVein(model::NodeId id) const {
    const auto match = m_table.match(m_scene.find(id)->name);
    return match && m_table.systems()[match->system].id == "vein";
  }

  const model::Scene& m_scene;
  model::Tissues m_tissues;
  model::AnatomyTable m_table;
  model::MeshTrees m_trees;
};

}  // namespace

std::vector<VesselChain> vesselChains(const model::Scene& scene) {
  ChainFinder finder(scene);
  std::vector<VesselChain> chains;
  for (const model::Node& node : scene.nodes())
    if (node.isGroup())
      if (std::vector<model::NodeId> vessels = finder.chainIn(node.id); !vessels.empty())
        chains.push_back({node.id, std::move(vessels)});
  return chains;
}

}  // namespace sline::render
