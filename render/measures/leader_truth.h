// SPDX-License-Identifier: Apache-2.0
// Judges by pictures alone whether labels point at what they name, without knowing how places are
// chosen. The scene is drawn twice with one structure in two loud colours, ink and fill alike:
// where the two pictures differ that structure is what one sees, by as much as they differ. Done
// with each structure, it tells what one sees at every pixel.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"

namespace sline::render {

/// Describes what a label tells the reader.
struct LeaderEnd {
  model::NodeId structure;  ///< the one that it names
  glm::vec2 place{0.0f};    ///< where its leader ends, in pixels from the upper left corner
  bool dashed = false;      ///< it says that the place is hidden
};

enum class LeaderFault {
  none,
  onAnother,         ///< another structure is what one sees there, and the leader is not dashed
  besideIt,          ///< one sees nothing there, and it is outside the structure's silhouette
  dashedWhereSeen,   ///< dashed although the structure is what one sees there
  dashedThoughSeen,  ///< the structure can be seen elsewhere in the picture, with room for a dot
  underTheDot        ///< what shows of it there is so little that the dot covers it
};

struct LeaderVerdict {
  LeaderFault fault = LeaderFault::none;
  /// What covers most of the dot; absent where it is nothing but ground.
  std::optional<model::NodeId> seen;
  float own = 0.0f;      ///< the share of the dot where one sees the named structure
  float another = 0.0f;  ///< that where one sees another one, the one with most
};

/// Describes a picture that labels are judged in.
struct JudgedPicture {
  const model::Scene& scene;
  const model::Camera& camera;
  PictureSettings settings;
  float dotRadius = 2.0f;  ///< pixels
};

/// Returns a verdict for each of the ends, in their order. Some 2·n + 2·m pictures are drawn for n
/// visible structures of which m are named.
Result<std::vector<LeaderVerdict>> judgeLeaders(const DrawPicture& draw,
                                                const JudgedPicture& picture,
                                                std::span<const LeaderEnd> ends);

}  // namespace sline::render
