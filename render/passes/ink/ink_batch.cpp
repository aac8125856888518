// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ink/ink_batch.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render::passes {

namespace {

// What pieces of a straight stroke lie over each other, px.
constexpr float pieceOverlap = 0.25f;

float kindOf(const Stroke& stroke) {
  switch (stroke.kind) {
    case StrokeKind::contour:
      return 1.0f + stroke.innerShare;
    case StrokeKind::hatching:
      return -stroke.softness;
    case StrokeKind::surfaceLine:
      break;
  }
  return 0.0f;
}

bool isOutside(InkKind kind) {
  return kind != InkKind::surfaceLines;
}

int stepsOf(const Stroke& s) {
  return int(std::ceil(std::min(glm::distance(s.a, s.b), float(mostInkSteps))));
}

glm::vec2 outside(float halfWidth, const glm::vec2& outward) {
  return std::max(halfWidth - 0.5f, 0.0f) * outward;
}

/// Makes the stroke end at the share `t` of its way, or begin there. The pen's way stays straight.
struct Cut {
  glm::vec2 at, outward, move;
  float depth, halfWidth, opacity;

  Cut(const Stroke& s, float t)
      : at(glm::mix(s.a, s.b, t)),
        outward(glm::mix(s.outwardA, s.outwardB, t)),
        depth(glm::mix(s.depthA, s.depthB, t)),
        halfWidth(glm::mix(s.halfWidthA, s.halfWidthB, t)),
        opacity(glm::mix(s.opacityA, s.opacityB, t)) {
    const glm::vec2 pen = glm::mix(s.a + s.moveA + outside(s.halfWidthA, s.outwardA),
                                   s.b + s.moveB + outside(s.halfWidthB, s.outwardB), t);
    move = pen - at - outside(halfWidth, outward);
  }
  void begin(Stroke& s) const {
    s.a = at, s.outwardA = outward, s.moveA = move, s.depthA = depth;
    s.halfWidthA = halfWidth, s.opacityA = opacity, s.capA = pieceOverlap;
  }
  void end(Stroke& s) const {
    s.b = at, s.outwardB = outward, s.moveB = move, s.depthB = depth;
    s.halfWidthB = halfWidth, s.opacityB = opacity, s.capB = pieceOverlap;
  }
};

}  // namespace

int inkPieces(const Stroke& stroke) {
  const float length = std::min(glm::distance(stroke.a, stroke.b), 1e6f);
  return std::max(1, int(std::ceil(length / float(mostInkSteps))));
}

Stroke inkPiece(const Stroke& stroke, int piece, int pieces) {
  Stroke result = stroke;
  if (piece > 0)
    Cut(stroke, float(piece) / float(pieces)).begin(result);
  if (piece + 1 < pieces)
    Cut(stroke, float(piece + 1) / float(pieces)).end(result);
  return result;
}

void InkBatch::clear() {
  m_vertices.clear();
  m_runs.clear();
  m_strokes.clear();
  m_looks.clear();
}

void InkBatch::add(const InkDraw& draw, const Stroke& s) {
  if (m_runs.empty() || m_runs.back().draw != &draw) {
    m_runs.push_back({&draw, m_vertices.size(), 0});
    const PixelRect& slot = draw.slot;
    m_looks.emplace_back(slot.x, slot.y, slot.right() - 1, slot.top() - 1);
    m_looks.emplace_back(slot.x - draw.layer.x, slot.y - draw.layer.y, draw.reach);
    m_looks.emplace_back(draw.probe, draw.sheet, isOutside(draw.kind) ? 1.0f : 0.0f, 0.0f);
  }
  ++m_runs.back().count;
  const int steps = stepsOf(s);
  m_vertices.push_back({s.a, s.b, s.depthA, s.depthB, s.tolerance, kindOf(s), s.outwardA,
                        s.outwardB, s.moveA, s.moveB, s.halfWidthA, s.halfWidthB, s.opacityA,
                        s.opacityB, s.capA, s.capB, float(steps)});
  // A float holds whole numbers up to 2²⁴.
  static_assert(perRow * mostRows <= (1 << 20) && mostInkSteps < 16);
  const std::size_t word = 16 * (m_runs.size() - 1) + std::size_t(steps);
  m_strokes.emplace_back(s.a, s.b);
  m_strokes.emplace_back(s.outwardA, s.outwardB);
  m_strokes.emplace_back(s.depthA, s.depthB, s.tolerance, float(word));
}

std::span<const glm::vec4> InkBatch::filled(std::vector<glm::vec4>& texels) {
  texels.resize((texels.size() + rowTexels - 1) / rowTexels * rowTexels);
  return texels;
}

}  // namespace sline::render::passes
