// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "model/import/readers/gltf/gltf_document.h"

#include "model/import/source/values.h"

namespace sline::model {

namespace {
constexpr std::size_t deepestNode = 256;

/// Describes a node that is waiting to be visited and what it inherits.
struct NodeVisit {
  std::uint64_t node = 0;
  std::size_t depth = 0;
  std::vector<std::string> groups;
  glm::dmat4 toScene{1.0};
};

/// Returns the transform by §3.5.2: a column-major matrix, or translation · rotation · scale.
glm::dmat4 localTransform(const Json& node) {
  if (const std::vector<double> m = numbersMember(node, "matrix", 16); !m.empty())
    return glm::make_mat4(m.data());
  glm::dmat4 local(1.0);
  if (const std::vector<double> t = numbersMember(node, "translation", 3); !t.empty())
    local[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
  if (const std::vector<double> q = numbersMember(node, "rotation", 4); !q.empty()) {
    const glm::dquat rotation(q[3], q[0], q[1], q[2]);
    if (glm::length(rotation) > 0.0)
      local *= glm::mat4_cast(glm::normalize(rotation));
  }
  if (const std::vector<double> s = numbersMember(node, "scale", 3); !s.empty())
    for (int axis = 0; axis < 3; ++axis)
      local[axis] *= s[std::size_t(axis)];
  return local;
}

std::vector<std::uint64_t> indicesIn(const Json* list) {
  std::vector<std::uint64_t> indices;
  if (list && list->is_array())
    for (const Json& entry : *list)
      indices.push_back(entry.is_number_unsigned() ? entry.get<std::uint64_t>() : UINT64_MAX);
  return indices;
}

/// Returns the scene's own nodes; in a file without scenes, the nodes that are no other node's
/// children.
std::vector<std::uint64_t> rootNodes(const Json& root) {
  const Json* scene = element(root, "scenes", wholeMember(root, "scene").value_or(0));
  if (scene)
    return indicesIn(member(*scene, "nodes"));
  const Json* nodes = member(root, "nodes");
  const std::size_t count = nodes && nodes->is_array() ? nodes->size() : 0;
  std::vector<bool> isChild(count, false);
  for (std::size_t i = 0; i < count; ++i)
    for (const std::uint64_t child : indicesIn(member((*nodes)[i], "children")))
      if (child < count)
        isChild[std::size_t(child)] = true;
  std::vector<std::uint64_t> roots;
  for (std::size_t i = 0; i < count; ++i)
    if (!isChild[i])
      roots.push_back(i);
  return roots;
}
}  // namespace

Result<std::vector<GltfInstance>> meshInstances(const GltfDocument& document) {
  const Source& source = document.source;
  const Json* nodes = member(document.root, "nodes");
  std::vector<bool> visited(nodes && nodes->is_array() ? nodes->size() : 0, false);
  std::vector<NodeVisit> waiting;
  // Every node below carries the names above it: a short file could multiply long ones.
  std::uint64_t nameBytes = 0;
  // The node pushed last is visited first.
  const auto push = [&](std::vector<std::uint64_t> list, const NodeVisit& parent) {
    std::reverse(list.begin(), list.end());
    std::uint64_t bytes = 0;
    for (const std::string& group : parent.groups)
      bytes += sizeof(std::string) + group.size();
    nameBytes += bytes * list.size();
    if (nameBytes > document.budget / 2)
      return false;
    for (const std::uint64_t node : list)
      waiting.push_back({node, parent.depth + 1, parent.groups, parent.toScene});
    return true;
  };
  push(rootNodes(document.root), {});
  std::vector<GltfInstance> instances;
  while (!waiting.empty()) {
    NodeVisit visit = std::move(waiting.back());
    waiting.pop_back();
    const std::string place = placeOf("nodes", visit.node);
    const Json* node = element(document.root, "nodes", visit.node);
    if (!node)
      return source.at(place, "does not exist");
    if (visited[std::size_t(visit.node)])
      return source.at(place, "is reached twice: it has two parents or is its own ancestor");
    if (visit.depth > deepestNode)
      return source.at(place, "lies more than 256 levels deep");
    visited[std::size_t(visit.node)] = true;
    visit.toScene = visit.toScene * localTransform(*node);
    if (!isFinite(visit.toScene))
      return source.at(place, "its transform is not finite");
    const std::string name = textMember(*node, "name");
    if (const auto mesh = wholeMember(*node, "mesh")) {
      const Json* json = element(document.root, "meshes", *mesh);
      if (!json)
        return source.at(place, "refers to a mesh that does not exist");
      instances.push_back({*mesh, visit.node, name.empty() ? textMember(*json, "name") : name,
                           visit.groups, visit.toScene});
    }
    if (!name.empty())
      visit.groups.push_back(name);
    if (!push(indicesIn(member(*node, "children")), visit))
      return source.at(place,
                       "the names of its nodes are too many and too long for so small a file",
                       "Give the nodes above shorter names");
  }
  return instances;
}

}  // namespace sline::model
