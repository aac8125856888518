// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/gamma_offsets.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "model/base/parallel.h"
#include "model/scalars/distance.h"
#include "model/scalars/mean_curvature.h"
#include "model/scalars/occlusion.h"
#include "render/drawn/drawn_structure.h"

namespace sline::render {

namespace {

// How many fields, and curves over them, a surface keeps: those of the structures that share it.
constexpr std::size_t mostFields = 4;
constexpr std::size_t mostCurves = 4;

std::vector<float> scalarsOf(const model::Surface& surface, model::GammaScalar scalar,
                             const std::vector<model::MeshPtr>& targets) {
  switch (scalar) {
    case model::GammaScalar::occlusion:
      return model::ambientOcclusion(surface);
    case model::GammaScalar::curvature:
      return model::meanCurvature(surface);
    case model::GammaScalar::distance:
      return model::distancesTo(targets, surface.mesh->positions());
    case model::GammaScalar::painted:
    case model::GammaScalar::none:
      break;
  }
  return {};
}

/// Returns the meshes of all structures that the map measures distances to, but of the one that has
/// it.
std::vector<model::MeshPtr> targetsOf(const model::Scene& scene, model::NodeId own,
                                      const model::GammaMap& map) {
  std::vector<model::MeshPtr> meshes;
  for (const model::NodeId target : map.targets) {
    if (!scene.find(target))
      continue;
    for (const model::NodeId id : scene.structuresBelow(target))
      if (const model::MeshPtr& mesh = scene.find(id)->mesh; id != own && mesh->triangleCount() > 0)
        meshes.push_back(mesh);
  }
  return meshes;
}

}  // namespace

GammaSpan gammaSpan(const model::ResolvedStyle& style) {
  if (!gammaVaries(style))
    return {style.gamma, style.gamma};
  const auto [low, high] =
      std::minmax_element(style.gammaMap.curve.begin(), style.gammaMap.curve.end(),
                          [](const auto& a, const auto& b) { return a.offset < b.offset; });
  return {Gamma::clamped(style.gamma.value() + low->offset),
          Gamma::clamped(style.gamma.value() + high->offset)};
}

float gammaAt(const model::Mesh& mesh, const GammaOffsets& offsets, Gamma own,
              std::uint32_t triangle, const glm::vec3& point) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const glm::vec3 p = mesh.positions()[a];
  const glm::vec3 u = mesh.positions()[b] - p;
  const glm::vec3 v = mesh.positions()[c] - p;
  const glm::vec3 n = glm::cross(u, v);
  const float area = std::max(glm::dot(n, n), 1e-30f);
  float weightB = glm::clamp(glm::dot(glm::cross(point - p, v), n) / area, 0.0f, 1.0f);
  float weightC = glm::clamp(glm::dot(glm::cross(u, point - p), n) / area, 0.0f, 1.0f);
  if (const float both = weightB + weightC; both > 1.0f) {
    weightB /= both;
    weightC /= both;
  }
  const float offset =
      (1.0f - weightB - weightC) * offsets[a] + weightB * offsets[b] + weightC * offsets[c];
  return Gamma::clamped(own.value() + offset).value();
}

std::shared_ptr<const std::vector<float>> GammaFields::field(
    const model::Surface& surface, model::GammaScalar scalar,
    const std::vector<model::MeshPtr>& targets) {
  for (const Field& known : m_fields)
    if (known.scalar == scalar && known.targets == targets)
      return known.values;
  if (m_fields.size() >= mostFields)
    m_fields.erase(m_fields.begin());
  m_fields.push_back(
      {scalar, targets,
       std::make_shared<const std::vector<float>>(scalarsOf(surface, scalar, targets))});
  return m_fields.back().values;
}

std::shared_ptr<const std::vector<float>> GammaFields::fromPlace(
    const model::Surface& surface, const model::GammaMap& map,
    const std::vector<model::MeshPtr>& targets) {
  const auto others = targets.empty() ? nullptr : field(surface, map.scalar, targets);
  FromPlace& known = m_fromPlace;
  if (known.values && known.place == *map.place && known.targets == others)
    return known.values;
  const auto positions = surface.mesh->positions();
  std::vector<float> values(positions.size());
  parallelFor(values.size(), 16384, [&](std::size_t v) {
    const float distance = glm::distance(positions[v], *map.place);
    values[v] = others ? std::min(distance, (*others)[v]) : distance;
  });
  known = {*map.place, others, std::make_shared<const std::vector<float>>(std::move(values))};
  return known.values;
}

GammaOffsetsPtr GammaFields::at(const model::Surface& surface, const model::GammaMap& map,
                                const std::vector<model::MeshPtr>& targets) {
  const std::lock_guard lock(m_mutex);
  std::shared_ptr<const std::vector<float>> values;
  isolated([&] {
    values = map.place ? fromPlace(surface, map, targets) : field(surface, map.scalar, targets);
  });
  for (const Curve& known : m_curves)
    if (known.values == values && known.points == map.curve)
      return known.offsets;
  GammaOffsets offsets(values->size());
  isolated([&] {
    parallelFor(offsets.size(), 16384,
                [&](std::size_t v) { offsets[v] = map.offsetAt((*values)[v]); });
  });
  if (m_curves.size() >= mostCurves)
    m_curves.erase(m_curves.begin());
  m_curves.push_back({values, map.curve, std::make_shared<const GammaOffsets>(std::move(offsets))});
  return m_curves.back().offsets;
}

GammaOffsetsPtr GammaFields::at(const model::PaintPtr& paint, const model::GammaMap& map) {
  const std::lock_guard lock(m_mutex);
  for (const Painted& known : m_painted)
    if (known.paint == paint && known.points == map.curve)
      return known.offsets;
  std::array<float, 256> offsetOf{};
  for (std::size_t value = 0; value < offsetOf.size(); ++value)
    offsetOf[value] = map.offsetAt(float(value) / 255.0f);
  GammaOffsets offsets(paint->size());
  std::transform(paint->begin(), paint->end(), offsets.begin(),
                 [&](std::uint8_t value) { return offsetOf[value]; });
  if (m_painted.size() >= mostCurves)
    m_painted.erase(m_painted.begin());
  m_painted.push_back({paint, map.curve, std::make_shared<const GammaOffsets>(std::move(offsets))});
  return m_painted.back().offsets;
}

namespace {

/// Makes Γ the same everywhere, as where the scalar has that value.
void level(model::ResolvedStyle& style, float scalar) {
  style.gamma = Gamma::clamped(style.gamma.value() + style.gammaMap.offsetAt(scalar));
  style.gammaMap = {};
}

/// Returns how far the place lies from the box at least.
float distanceFrom(const model::Box& box, const glm::vec3& place) {
  return glm::length(glm::max(glm::max(box.low - place, place - box.high), 0.0f));
}

}  // namespace

void findGammaOffsets(const model::Scene& scene, DrawnStructure& shown) {
  if (!gammaVaries(shown.style))
    return;
  model::GammaMap& map = shown.style.gammaMap;
  if (map.scalar == model::GammaScalar::painted) {
    const model::Node* node = scene.find(shown.id);
    if (!node || !node->paint || node->paint->size() != shown.surface().mesh->vertexCount())
      return level(shown.style, 0.0f);
    shown.gammaOffsets = shown.prepared->gammaFields.at(node->paint, map);
    return;
  }
  std::vector<model::MeshPtr> targets;
  if (map.scalar == model::GammaScalar::distance)
    targets = targetsOf(scene, shown.id, map);
  if (map.scalar == model::GammaScalar::distance && targets.empty() && !map.place) {
    map = {};
    return;
  }
  // What lies beyond the curve stays the same while the place is dragged, and so does its drawing.
  if (const float beyond = map.curve.back().scalar;
      map.place && targets.empty() && distanceFrom(shown.mesh->bounds(), *map.place) >= beyond)
    return level(shown.style, beyond);
  shown.gammaOffsets = shown.prepared->gammaFields.at(shown.surface(), map, targets);
}

}  // namespace sline::render
