// SPDX-License-Identifier: Apache-2.0
// Paints a layout of labels in the same way in pictures, on paper and in the window.
#pragma once

#include <QPainter>
#include <array>

#include "render/labels/layout.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Holds the labels of one picture, ready to be painted.
struct LabelPlate {
  LabelStyle style;
  std::vector<ShownLabel> labels;  ///< with boxes in their items
  std::vector<LabelText> texts;    ///< one per label, in their order
  LabelLayout layout;
  UnseenLabels unseen;
};

/// Describes what precedes a picture that is one of many, and what labels keep off.
struct LabelTurn {
  const LabelLayout* before = nullptr;  ///< that of the picture before
  bool moving = false;                  ///< as in LabelRequest: true until the camera rests
  bool hurried = false;                 ///< as in LabelsBefore
  bool still = false;                   ///< as in LabelRequest
  std::array<float, 2> widths{};        ///< as in LabelRequest
  const SeenArea* drawn = nullptr;      ///< as in LabelRequest
  bool anywhere = false;  ///< over anatomy, too: who is asked must not miss what has no ground
  /// The picture keeps its whole area, whatever that leaves its labels; else one that anatomy fills
  /// may get a frame with ground around it.
  bool whole = false;
  float sideMargin = 0.0f;  ///< as in LabelSpace
};

/// Holds what a picture's labels go by before they are laid out.
struct LabelSights {
  LabelsInPicture labels;
  ObstacleMask obstacles;
  glm::vec2 size{0.0f};        ///< of the output, millimetres
  glm::vec3 towardsEye{0.0f};  ///< as in LabelRequest
};
LabelSights labelSights(const model::Scene& scene, const Screen& screen,
                        const std::string& language, model::MeshTrees& trees,
                        const LabelsBefore& before = {});

/// Returns the width to which lines of labels are broken in a picture.
float textWidthOf(const LabelSights& sights, const LabelStyle& style);
/// Returns the request for a picture of a film, with the texts' boxes.
LabelRequest filmRequest(const LabelSights& sights, const LabelStyle& style, float textWidth);

/// Lays out the labels.
LabelPlate labelPlate(const LabelSights& sights, const LabelStyle& style, const LabelTurn& turn);

/// Lays out the scene's labels on that screen.
LabelPlate labelPlate(const model::Scene& scene, const Screen& screen, const LabelStyle& style,
                      model::MeshTrees& trees, const LabelTurn& turn = {});

/// Returns the plate as shapes and text, an item for each label that has a place. A hidden place is
/// an open dot at a dashed leader.
Lettering letteringOf(const LabelPlate& plate);

/// Paints the plate. The painter's unit must be a millimetre, from the picture's upper left corner.
void paintLabels(QPainter& painter, const LabelPlate& plate);

}  // namespace sline::render
