// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/ink.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/sight/rules.h"

namespace sline::render {

namespace {

// What pieces of a straight stroke lie over each other, px.
constexpr float pieceOverlap = 0.25f;

glm::vec2 outside(float halfWidth, const glm::vec2& outward) {
  return rule::penOutside(halfWidth) * outward;
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

int inkSteps(const Stroke& stroke) {
  return int(std::ceil(std::min(glm::distance(stroke.a, stroke.b), float(mostInkSteps))));
}

}  // namespace sline::render
