// SPDX-License-Identifier: Apache-2.0
#include "model/edit/painting.h"

#include <algorithm>

namespace sline::model {

namespace {

bool same(const PaintPtr& a, const PaintPtr& b) {
  return a == b || (a && b && *a == *b);
}

bool isNothing(const Paint& paint) {
  return std::all_of(paint.begin(), paint.end(), [](std::uint8_t value) { return value == 0; });
}

}  // namespace

std::vector<GammaPoint> firstPaintedCurve(Gamma own) {
  constexpr float shaded = 4.3f;
  constexpr float lines = 2.5f;
  const float raised = std::max(shaded - own.value(), 0.0f);
  return {{0.0f, own.value() <= lines ? 0.0f : -3.0f}, {1.0f, raised}};
}

Edited withPaint(const Scene& scene, NodeId structure, PaintPtr paint) {
  const Node* node = scene.find(structure);
  if (!node || node->isGroup() || scene.isLocked(structure))
    return {scene, false};
  // What is there for other vertices would be read beyond its end.
  if (paint && paint->size() != node->mesh->vertexCount())
    return {scene, false};
  if (paint && isNothing(*paint))
    paint = nullptr;
  const ResolvedStyle style = scene.resolve(structure);
  const bool follows = style.gammaMap.scalar == GammaScalar::painted;
  if (same(node->paint, paint) && (follows || !paint))
    return {scene, false};
  std::vector<Node> nodes = scene.nodes();
  const auto place = std::find_if(nodes.begin(), nodes.end(),
                                  [structure](const Node& each) { return each.id == structure; });
  place->paint = std::move(paint);
  if (place->paint && !follows)
    place->style.gammaMap = GammaMap{
        .scalar = GammaScalar::painted, .targets = {}, .curve = firstPaintedCurve(style.gamma)};
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return {std::move(after), true};
}

}  // namespace sline::model
