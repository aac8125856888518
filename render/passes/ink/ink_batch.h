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
#include "render/strokes/stroke.h"

namespace sline::render::passes {

/// Tells what strokes draw: ink, the soft edges of a fill along its contours, outlines that show
/// through what lies before them, where lines behind an outline stop, or where a fill ends that was
/// enlarged.
enum class InkKind { surfaceLines, contours, edges, hidden, halos, trims };
inline constexpr std::size_t inkKindCount = 6;

struct InkDraw {
  InkKind kind = InkKind::surfaceLines;  ///< that of all its strokes
  std::span<const Stroke> strokes;       ///< farthest first
  PixelRect layer;                       ///< as in SurfaceDraw
  PixelRect slot;
  int surfaceStep = 1;         ///< pixels of the layer for one of its surface's depth, each way
  glm::vec4 projection{0.0f};  ///< projection matrix [2][2], [3][2], [2][3], [3][3]
  float probe = 3.0f;  ///< px outside a contour at which its own mask makes it an inner contour
  glm::vec2 reach{1.0f, 4.0f};  ///< px outside a contour at which the surface has fallen away
  glm::vec4 paint{0.0f};        ///< a fill's colour and opacity, for edges
  glm::vec3 key{0.0f};     ///< the surfaces' key light in the camera's frame, for edges; 0: none
  float grain = 0.0f;      ///< of a pencil on paper, 0 … 1, for ink
  float grainSize = 1.0f;  ///< px
  float sheet = 0.0f;  ///< mm in front of a contour within which its own sheet may lie (see .glsl)
};

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

/// Sight is looked for at so many places of a stroke, less one; longer strokes, in pixels, become
/// several.
inline constexpr int mostInkSteps = 15;

/// Returns the number of such pieces, and one of them; together they draw what the stroke draws.
int inkPieces(const Stroke& stroke);
Stroke inkPiece(const Stroke& stroke, int piece, int pieces);

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
