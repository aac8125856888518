// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_tone.h"

#include <array>
#include <glm/geometric.hpp>

#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
/// acos(x) / (π/2) for x in 0 … 1, within 5·10⁻⁵ (M. Abramowitz, I. Stegun, "Handbook of
/// Mathematical Functions", 4.4.45): the library's keeps the loop from being vectorised.
float quarterTurns(float x) {
  return 0.63661977f * std::sqrt(1.0f - x) *
         (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

/// METHOD §3: k = S w + (nv/d)·w. Seen from behind n and S change sign and w does not, so k turns.
HatchField fieldAt(const model::ClusterVertices& in, std::size_t i, const model::EyePoint& eye,
                   bool twoSided) {
  const glm::vec3 p{in.position[0][i], in.position[1][i], in.position[2][i]};
  const glm::vec3 n{in.normal[0][i], in.normal[1][i], in.normal[2][i]};
  const glm::vec3 toEye = eye.atInfinity ? eye.value : eye.value - p;
  const float distance = glm::length(toEye);
  const glm::vec3 v = toEye / std::max(distance, 1e-20f);
  const float nv = glm::dot(n, v);
  const glm::vec3 w = v - nv * n;
  glm::vec3 k{in.s[0][i] * w.x + in.s[1][i] * w.y + in.s[2][i] * w.z,
              in.s[1][i] * w.x + in.s[3][i] * w.y + in.s[4][i] * w.z,
              in.s[2][i] * w.x + in.s[4][i] * w.y + in.s[5][i] * w.z};
  if (!eye.atInfinity)
    k += nv / distance * w;
  float facing = nv;
  if (twoSided && nv < 0.0f) {
    k = -k;
    facing = -nv;
  }
  return {.k = k,
          .weight = -glm::dot(k, v),
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

HatchFields::HatchFields(const model::Surface& surface, const model::EyePoint& eye, bool twoSided)
    : m_fields(surface.mesh->vertexCount()) {
  const model::Clusters& clusters = surface.clusters;
  std::vector<std::uint8_t> hatched(clusters.items.size(), 0);
  const auto look = [&](std::size_t c) {
    const model::Cluster& cluster = clusters.items[c];
    // κr lies between the principal curvatures, so one sign for all means no concave direction.
    if (!twoSided &&
        (!(cluster.lowestCurvature < 0.0f) || model::facing(cluster, eye) == model::Facing::back))
      return;
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
      const std::size_t slot = cluster.firstVertex + i;
      HatchField field = fieldAt(clusters.fields, slot, eye, twoSided);
      field.weight *= surface.filigreeSize;
      if (field.weight > 0.0f && field.angle < 1.0f)
        hatched[c] = 1;
      m_fields[clusters.vertices[slot]] = field;
    }
  };
  // Clusters share vertices at their seams and would write the same value to the same place.
  for (std::size_t c = 0; c < clusters.items.size(); ++c)
    look(c);
  for (std::size_t c = 0; c < hatched.size(); ++c)
    if (hatched[c])
      m_clusters.push_back(std::uint32_t(c));
}

}  // namespace sline::render
