// SPDX-License-Identifier: Apache-2.0
// Paints a layout of labels: the same in pictures, on paper and in the window.
#pragma once

#include <QPainter>

#include "render/labels/layout.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// The labels of one picture, ready to be painted.
struct LabelPlate {
  LabelStyle style;
  std::vector<ShownLabel> labels;  ///< their items have boxes
  std::vector<LabelText> texts;    ///< of the labels, in their order
  LabelLayout layout;
};

/// What a picture follows, where it is one of many.
struct LabelTurn {
  const LabelLayout* before = nullptr;  ///< of the picture before it
  bool moving = false;                  ///< as in LabelRequest: true until the camera rests
};

/// The scene's labels on that screen.
LabelPlate labelPlate(const model::Scene& scene, const Screen& screen, const LabelStyle& style,
                      model::MeshTrees& trees, const LabelTurn& turn = {});

/// As shapes and text, an item for each label that has a place. A place that something hides is an
/// open dot at a dashed leader.
Lettering letteringOf(const LabelPlate& plate);

/// The painter's unit must be a millimetre, from the picture's upper left corner.
void paintLabels(QPainter& painter, const LabelPlate& plate);

}  // namespace sline::render
