// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_tone.h"

#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
/// Returns acos(x) / (π/2) for x in 0 … 1, within 5·10⁻⁵ (M. Abramowitz, I. Stegun, "Handbook of
/// Mathematical Functions", 4.4.45); the library's function keeps the loop from being vectorised.
float quarterTurns(float x) {
  return 0.63661977f * std::sqrt(1.0f - x) *
         (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

// Cosines to the light: below the first all is shadow, above the second nothing.
constexpr float wholeShadow = -0.35f;
constexpr float noShadow = 0.3f;
constexpr float shadowWeight = 0.45f;
// The second, where hatching is as dark as a woodcut's; it begins where tones for print end.
constexpr float noShadowWhereDark = 0.95f;
constexpr float usualTone = 1.8f;
constexpr float woodcutTone = 2.4f;

/// Returns the cosine to the light from which on there is no shadow.
float endOfShadow(float tone) {
  const float dark = std::clamp((tone - usualTone) / (woodcutTone - usualTone), 0.0f, 1.0f);
  return noShadow + dark * (noShadowWhereDark - noShadow);
}

/// Computes the field by METHOD §3: k = S w + (nv/d)·w. Seen from behind, n and S change sign and w
/// does not, so k turns.
HatchField fieldAt(const model::Surface& surface, std::uint32_t vertex, const HatchView& view) {
  const model::SurfaceVertex& at = surface.vertices[vertex];
  const glm::vec3& n = at.normal;
  const glm::vec3 toEye = vectorTo(view.eye, at.position);
  const float distance = glm::length(toEye);
  const glm::vec3 v = toEye / std::max(distance, 1e-20f);
  const float nv = glm::dot(n, v);
  const glm::vec3 k = lightGradient(
      n, at.e1, at.k, v, view.eye.atInfinity ? std::numeric_limits<float>::infinity() : distance);
  const float side = view.twoSided && nv < 0.0f ? -1.0f : 1.0f;
  const float facing = side * nv;
  const float lit = std::clamp(
      (side * glm::dot(n, view.light) - wholeShadow) / (endOfShadow(view.tone) - wholeShadow), 0.0f,
      1.0f);
  const float shadow = 1.0f - lit * lit * (3.0f - 2.0f * lit);
  return {.weight = std::max(-side * glm::dot(k, v) * surface.filigreeSize, shadowWeight * shadow),
          .angle = facing > 0.0f ? quarterTurns(std::min(facing, 1.0f)) : 1.0f - facing};
}
constexpr std::size_t tableSize = 64;

std::array<float, tableSize + 2> widthTable() {
  std::array<float, tableSize + 2> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = 0.62f * std::pow(float(i) / float(tableSize), 1.2f);
  return table;
}
}  // namespace

float hatchWidth(float opacity) {
  static const std::array<float, tableSize + 2> table = widthTable();
  const float x = std::sqrt(std::clamp(opacity, 0.0f, 1.0f)) * float(tableSize);
  const std::size_t i = std::size_t(x);
  return table[i] + (x - float(i)) * (table[i + 1] - table[i]);
}

HatchFields::HatchFields(const model::Surface& surface, const HatchView& view)
    : m_fields(surface.mesh->vertexCount()) {
  const model::Clusters& clusters = surface.clusters;
  for (std::size_t c = 0; c < clusters.items.size(); ++c) {
    const model::Cluster& cluster = clusters.items[c];
    if (!view.twoSided && model::facing(cluster, view.eye) == model::Facing::back)
      continue;
    bool hatched = false;
    // Clusters share vertices at their seams and write the same value to the same place.
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
      const std::uint32_t vertex = clusters.vertices[cluster.firstVertex + i];
      const HatchField field = fieldAt(surface, vertex, view);
      hatched |= field.weight > 0.0f && field.angle < 1.0f;
      m_fields[vertex] = field;
    }
    if (hatched)
      m_clusters.push_back(std::uint32_t(c));
  }
}

}  // namespace sline::render
