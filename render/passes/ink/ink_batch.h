// SPDX-License-Identifier: Apache-2.0
// Lays strokes out as the ink pass' programs read them: as instances of capsules, and as texels of
// the search for what is in sight.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/gpu/device.h"
#include "render/strokes/ink.h"

namespace sline::render::passes {

/// A stroke as ink.vert.glsl reads it.
struct InkVertex {
  glm::vec2 a;
  glm::vec2 b;
  float depthA;
  float depthB;
  float tolerance;
  /// 0: a line on the surface; 1 … 2: a contour, 1 + the share of it that remains within the
  /// surface's own mask; below 0: hatching, minus the pixels over which its edge fades.
  float kind;
  glm::vec2 outwardA;
  glm::vec2 outwardB;
  glm::vec2 moveA;
  glm::vec2 moveB;
  float halfWidthA;
  float halfWidthB;
  float opacityA;
  float opacityB;
  float capA;
  float capB;
  float steps;  ///< places at which it is looked for, less one
};

class InkBatch {
 public:
  /// Strokes, and looks of draws, in a row of their textures (see sight.frag.glsl).
  static constexpr int perRow = 256;
  static constexpr int mostRows = 1024;

  /// Some strokes of a draw that lie one after the other.
  struct Run {
    const InkDraw* draw = nullptr;
    std::size_t first = 0;
    std::size_t count = 0;
  };

  bool empty() const { return m_runs.empty(); }
  bool full() const { return m_vertices.size() >= std::size_t(perRow) * mostRows; }
  void clear();
  /// Adds a stroke no longer than `mostInkSteps` of a draw, which must outlive the batch.
  void add(const InkDraw& draw, const Stroke& stroke);

  std::span<const InkVertex> vertices() const { return m_vertices; }
  std::span<const Run> runs() const { return m_runs; }
  /// Returns whole rows of texels, three for each stroke or look.
  std::span<const glm::vec4> strokeTexels() { return filled(m_strokes); }
  std::span<const glm::vec4> lookTexels() { return filled(m_looks); }
  static int rowsOf(std::span<const glm::vec4> texels) { return int(texels.size()) / rowTexels; }
  static constexpr int rowTexels = 3 * perRow;

 private:
  static std::span<const glm::vec4> filled(std::vector<glm::vec4>& texels);

  std::vector<InkVertex> m_vertices;
  std::vector<Run> m_runs;
  std::vector<glm::vec4> m_strokes;
  std::vector<glm::vec4> m_looks;  ///< one of each run
};

}  // namespace sline::render::passes
