// SPDX-License-Identifier: Apache-2.0
// Describes how labels look, in millimetres and points of the output: on a picture printed twice as
// large they are no larger.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/scene/look.h"
#include "render/drawn/picture_settings.h"
#include "render/labels/seen/shapes.h"

namespace sline::render {

/// Tells what labels show. `numbers`: numbered badges, for a key beside the picture; `blank`: lines
/// to write on.
enum class LabelMode { off, on, numbers, blank };

inline constexpr float millimetresPerInch = 25.4f;
inline constexpr float millimetresPerPoint = millimetresPerInch / 72.0f;
/// The height that a picture is taken to have if none is given: its 720 output units (METHOD §4)
/// are then 1/96 inch each.
inline constexpr float usualHeightMm = 190.5f;

inline constexpr Limits<float> letterLimitsPt{4.0f, 48.0f};

/// How structures look in colour, of a picture that has black ink alone; null for others.
using LooksInColour = std::shared_ptr<const std::vector<model::Look>>;

struct LabelStyle {
  LabelMode mode = LabelMode::on;
  float points = 10.0f;                   ///< size of the text
  std::string language;                   ///< BCP 47 tag; of texts and numbers
  Background ground = Background::white;  ///< decides ink and halos
  bool seenOnly = false;                  ///< leaves out what would point at a hidden place
  LooksInColour inColour;                 ///< decides what one sees, and so where labels stand
  EdgeRoom edges;                         ///< the room where no text stands, as other marks do
  /// Boxes around other marks, in the output, where neither texts nor leaders stand.
  std::vector<LabelBox> reserved;
};

}  // namespace sline::render
