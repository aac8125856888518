// SPDX-License-Identifier: Apache-2.0
#include "model/pockets/pocket_focus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "model/edit/look.h"
#include "model/isosurface/zero_surface.h"

namespace sline::model {

namespace {

constexpr const char* pocketsGroup = "Pockets";
constexpr Colour roomColour{226, 198, 138};
// The looks: lines for the molecule, whose Γ rises by that much at the wall and not beyond.
constexpr float lineGamma = 1.0f;
constexpr float wallRise = 3.7f;
constexpr float wallWidth = 1.2f;  // mm
constexpr float wallEnd = 3.5f;
constexpr float guestGamma = 5.0f;
constexpr float faintGamma = 0.0f;
constexpr float faintPen = 0.4f;
// A view into a pocket shows so many times its radius.
constexpr float viewShare = 2.6f;

/// A field over the box around a pocket's places: 1 within, 0 outside, blurred so that the surface
/// between them has no steps.
struct RoomField {
  glm::ivec3 first{0};  ///< a place of the grid
  glm::ivec3 size{0};
  std::vector<float> values;

  std::size_t at(const glm::ivec3& cell) const {
    return (std::size_t(cell.z) * std::size_t(size.y) + std::size_t(cell.y)) * std::size_t(size.x) +
           std::size_t(cell.x);
  }
};

void blurAlong(RoomField& field, int axis) {
  const std::vector<float> before = field.values;
  for (int z = 0; z < field.size.z; ++z)
    for (int y = 0; y < field.size.y; ++y)
      for (int x = 0; x < field.size.x; ++x) {
        glm::ivec3 cell(x, y, z);
        float sum = 2.0f * before[field.at(cell)];
        for (const int side : {-1, 1}) {
          glm::ivec3 next = cell;
          next[axis] = std::clamp(next[axis] + side, 0, field.size[axis] - 1);
          sum += before[field.at(next)];
        }
        field.values[field.at(cell)] = 0.25f * sum;
      }
}

RoomField roomField(const ProbeGrid& grid, const Pocket& pocket) {
  constexpr int margin = 3;
  glm::ivec3 low = grid.cell(pocket.cells.front());
  glm::ivec3 high = low;
  for (const std::uint32_t i : pocket.cells) {
    low = glm::min(low, grid.cell(i));
    high = glm::max(high, grid.cell(i));
  }
  RoomField field{.first = low - margin, .size = high - low + 1 + 2 * margin, .values = {}};
  field.values.assign(
      std::size_t(field.size.x) * std::size_t(field.size.y) * std::size_t(field.size.z), 0.0f);
  for (const std::uint32_t i : pocket.cells)
    field.values[field.at(grid.cell(i) - field.first)] = 1.0f;
  for (int round = 0; round < 2; ++round)
    for (int axis = 0; axis < 3; ++axis)
      blurAlong(field, axis);
  for (float& value : field.values)
    value -= 0.5f;
  return field;
}

double signedVolumeOf(const ZeroSurface& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += double(
        glm::dot(surface.positions[a], glm::cross(surface.positions[b], surface.positions[c])));
  return sum;
}

/// Returns the structure that stands for the pocket's room, made or made anew.
NodeId withRoom(Scene& scene, const PocketMolecule& molecule, const ScenePocket& pocket,
                const MeshPtr& body) {
  const std::string name = "Pocket " + std::to_string(pocket.number);
  NodeId group = rootId;
  for (const NodeId child : scene.children(molecule.group))
    if (scene.find(child)->isGroup() && scene.find(child)->name == pocketsGroup)
      group = child;
  if (group == rootId) {
    Node node;
    node.parent = molecule.group;
    node.name = pocketsGroup;
    group = scene.append(std::move(node));
  }
  for (const NodeId child : scene.children(group)) {
    if (scene.find(child)->name != name || !scene.find(child)->mesh)
      continue;
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      if (node.id == child)
        node.mesh = body;
    scene.setNodes(std::move(nodes));
    return child;
  }
  Node node;
  node.parent = group;
  node.name = name;
  node.mesh = body;
  node.style.colour = roomColour;
  node.style.visible = false;
  return scene.append(std::move(node));
}

Style lookAtWall(NodeId room) {
  Style look;
  look.gamma = Gamma::clamped(lineGamma);
  look.fill = Fill::paper;
  look.opacity = Opacity::clamped(1.0f);
  // Where Γ falls off, hatching would be a fringe of ticks.
  look.hatchDensity = HatchDensity::clamped(0.0f);
  look.gammaMap = GammaMap{.scalar = GammaScalar::distance,
                           .targets = {room},
                           .curve = {{0.0f, wallRise}, {wallWidth, wallRise}, {wallEnd, 0.0f}}};
  return look;
}

Style lookOfGuest() {
  Style look;
  look.gamma = Gamma::clamped(guestGamma);
  look.opacity = Opacity::clamped(1.0f);
  look.visible = true;
  look.gammaMap = GammaMap{};
  return look;
}

Style lookOfOthers() {
  Style look;
  look.gamma = Gamma::clamped(faintGamma);
  look.fill = Fill::none;
  look.penWeight = faintPen;
  look.gammaMap = GammaMap{};
  return look;
}

}  // namespace

MeshPtr pocketBody(const ProbeGrid& grid, const Pocket& pocket) {
  if (pocket.cells.empty())
    return nullptr;
  const RoomField field = roomField(grid, pocket);
  ZeroSurface surface = zeroSurface({.size = field.size,
                                     .origin = grid.place(field.first),
                                     .step = glm::dvec3(grid.step),
                                     .values = field.values});
  if (signedVolumeOf(surface) < 0.0)
    for (Triangle& t : surface.triangles)
      std::swap(t[1], t[2]);
  Result<Mesh> mesh = Mesh::create(std::move(surface.positions), std::move(surface.triangles));
  return mesh ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
}

Edited withPocketInFocus(const Scene& scene, const ScenePockets& found, std::size_t index,
                         const MeshPtr& body) {
  const ScenePocket& pocket = found.pockets[index];
  const PocketMolecule& molecule = found.molecules[pocket.molecule];
  const bool lost = std::none_of(molecule.chains.begin(), molecule.chains.end(),
                                 [&](NodeId id) { return scene.find(id); });
  if (lost || (molecule.group != rootId && !scene.find(molecule.group)) || !body)
    return {scene, false};
  Scene edited = scene;
  const NodeId room = withRoom(edited, molecule, pocket, body);
  const std::vector<NodeId> guests = edited.structuresBelow(pocket.guests);
  std::vector<NodeId> linings;
  std::vector<NodeId> others;
  for (const NodeId id : edited.structuresBelow(rootId)) {
    const auto among = [id](const std::vector<NodeId>& ids) {
      return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    if (id == room || among(guests) || among(molecule.chains))
      continue;
    const Node* group = edited.find(edited.find(id)->parent);
    (group && group->name == pocketsGroup ? linings : others).push_back(id);
  }
  // Linings lie on the walls, which they would hide.
  Style hidden;
  hidden.visible = false;
  edited = withLook(edited, linings, hidden).scene;
  edited = withLook(edited, others, lookOfOthers()).scene;
  edited = withLook(edited, molecule.chains, lookAtWall(room)).scene;
  edited = withLook(edited, guests, lookOfGuest()).scene;
  edited.setFocus({});
  return {std::move(edited), true};
}

Camera viewIntoPocket(const ScenePocket& pocket, const Camera& from) {
  const glm::vec3 centre(pocket.pocket.centre);
  glm::vec3 back(pocket.pocket.outwards);
  if (!(glm::length(back) > 0.5f))
    back = cameraFrame(from).back;
  glm::vec3 up = from.up;
  if (glm::length(glm::cross(up, back)) < 0.1f * glm::length(up))
    up = std::abs(back.z) < 0.9f ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  constexpr double fullTurn = 4.1887902;  // 4π/3
  const auto radius = float(std::cbrt(std::max(pocket.pocket.volume, 1.0) / fullTurn)) * viewShare;
  Camera camera = from;
  camera.target = centre;
  camera.up = up;
  camera.heightMm = 2.0f * radius;
  camera.eye = centre + back * (radius / edgeSlope(from));
  return camera;
}

}  // namespace sline::model
