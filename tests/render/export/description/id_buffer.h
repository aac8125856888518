// SPDX-License-Identifier: Apache-2.0
// Tells which structure each pixel of a picture of opaque structures shows, by a rasteriser that
// shares nothing with what is tested but the projection.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "model/scene/visible_structures.h"
#include "render/labels/seen/screen.h"

namespace sline::test {

class IdBuffer {
 public:
  IdBuffer(const model::Scene& scene, const render::Screen& screen, int height)
      : m_screen(screen),
        m_scale(float(height) / screen.size().y),
        m_columns(int(std::ceil(screen.size().x * m_scale))),
        m_rows(height) {
    for (const model::VisibleStructure& structure : model::visibleStructures(scene))
      draw(*structure.node);
    m_nearest.assign(std::size_t(m_columns * m_rows), {model::rootId, nothing});
    for (const auto& [id, depths] : m_depths)
      for (std::size_t i = 0; i < m_nearest.size(); ++i)
        if (depths[i] < m_nearest[i].second)
          m_nearest[i] = {id, depths[i]};
    for (std::size_t i = 0; i < m_nearest.size(); ++i)
      if (m_nearest[i].first.value != 0) {
        ++m_pixels[m_nearest[i].first];
        m_across[m_nearest[i].first] += (float(i % std::size_t(m_columns)) + 0.5f) / m_scale;
      }
  }

  /// Returns how many pixels show the structure.
  int pixels(model::NodeId id) const {
    const auto found = m_pixels.find(id);
    return found == m_pixels.end() ? 0 : found->second;
  }
  /// Returns where the middle of what shows of it lies, as a share of the picture's width.
  float across(model::NodeId id) const {
    return m_across.at(id) / float(pixels(id)) / m_screen.size().x;
  }
  /// Returns in how many pixels the first structure lies before the second.
  int before(model::NodeId first, model::NodeId second) const {
    int count = 0;
    const auto a = m_depths.find(first);
    const auto b = m_depths.find(second);
    for (std::size_t i = 0; a != m_depths.end() && b != m_depths.end() && i < m_nearest.size(); ++i)
      count += a->second[i] < b->second[i] && b->second[i] < nothing ? 1 : 0;
    return count;
  }

 private:
  static constexpr float nothing = 1e30f;

  void draw(const model::Node& node) {
    std::vector<float>& depths = m_depths[node.id];
    depths.assign(std::size_t(m_columns * m_rows), nothing);
    const auto& positions = node.mesh->positions();
    for (const model::Triangle& triangle : node.mesh->triangles()) {
      glm::vec3 corners[3];
      bool seen = true;
      for (int i = 0; i < 3 && seen; ++i) {
        const glm::vec3& p = positions[triangle[std::size_t(i)]];
        const auto place = m_screen.place(p);
        seen = place.has_value();
        if (seen)
          corners[i] = glm::vec3(*place * m_scale, m_screen.depthKey(p));
      }
      if (seen)
        fill(corners, depths);
    }
  }

  void fill(const glm::vec3* corners, std::vector<float>& depths) const {
    const glm::vec3& a = corners[0];
    const glm::vec3 u = corners[1] - a;
    const glm::vec3 v = corners[2] - a;
    const float area = u.x * v.y - u.y * v.x;
    if (area == 0.0f)
      return;
    const auto low = [&](int axis, int most) {
      const float least = std::min({a[axis], corners[1][axis], corners[2][axis]});
      return std::clamp(int(std::floor(least - 0.5f)), 0, most);
    };
    const auto high = [&](int axis, int most) {
      const float largest = std::max({a[axis], corners[1][axis], corners[2][axis]});
      return std::clamp(int(std::ceil(largest + 0.5f)), 0, most);
    };
    for (int y = low(1, m_rows); y < high(1, m_rows); ++y)
      for (int x = low(0, m_columns); x < high(0, m_columns); ++x) {
        const float px = float(x) + 0.5f - a.x;
        const float py = float(y) + 0.5f - a.y;
        const float s = (px * v.y - py * v.x) / area;
        const float t = (u.x * py - u.y * px) / area;
        if (s < 0.0f || t < 0.0f || s + t > 1.0f)
          continue;
        float& depth = depths[std::size_t(y * m_columns + x)];
        depth = std::min(depth, a.z + s * u.z + t * v.z);
      }
  }

  render::Screen m_screen;
  float m_scale;
  int m_columns;
  int m_rows;
  std::map<model::NodeId, std::vector<float>> m_depths;
  std::vector<std::pair<model::NodeId, float>> m_nearest;
  std::map<model::NodeId, int> m_pixels;
  std::map<model::NodeId, float> m_across;
};

}  // namespace sline::test
