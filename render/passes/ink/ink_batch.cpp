// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ink/ink_batch.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render::passes {

namespace {

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

}  // namespace

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
  const int steps = inkSteps(s);
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
