// SPDX-License-Identifier: Apache-2.0
// Where labels stand in a picture: one layout for the window, pixels, vectors and print. Labels and
// callouts stand in two columns beside the anatomy (column.h), pins and distances beside their own
// place where there is room. While a camera turns, each layout starts from the one before, and what
// may stay stays: sides, order and columns change only where they must or where much is gained, and
// what has jumped rests for the next 20° where others can give way (after Ali, Hartmann and
// Strothotte: Label layout for interactive 3D illustrations. Journal of the WSCG 13, 2005).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "model/scene/annotation.h"
#include "render/labels/obstacles.h"
#include "render/labels/shapes.h"

namespace sline::render {

struct LabelItem {
  model::AnnotationId id;
  model::AnnotationKind kind = model::AnnotationKind::label;
  std::vector<glm::vec2> places;  ///< millimetres of the output; one, of a distance two
  bool hidden = false;            ///< something, or its own structure, is before the place
  glm::vec2 box{0.0f};            ///< what the text needs, with its padding
  /// Moved by hand: the box's middle from the place.
  std::optional<glm::vec2> offset;
};

/// The output, in millimetres.
struct LabelSpace {
  glm::vec2 size{0.0f};
  float sideMargin = 0.0f;  ///< beyond the left and right side, where boxes may stand too
  EdgeRoom edges;           ///< where no box stands
  /// Where neither boxes nor leaders are: something else stands there.
  std::vector<LabelBox> reserved;
};

struct LabelRequest {
  std::vector<LabelItem> items;  ///< each id once
  LabelSpace space;
  ObstacleMask obstacles;
  /// From the scene to the eye, a unit vector: how far the camera has turned since a label jumped.
  glm::vec3 towardsEye{0.0f};
  /// The camera is on its way: who has just jumped does not jump again, but is left out where there
  /// is no other way, until the camera rests or 20° are behind it.
  bool moving = false;
  float textWidth = 0.0f;  ///< what texts were broken to; handed through, for layouts that follow
};

/// `beside`: its place, without a leader.
enum class LabelPost { left, right, beside, byHand };

struct PlacedLabel {
  model::AnnotationId id;
  LabelPost post = LabelPost::left;
  LabelBox box;
  Leader leader;  ///< empty where it needs none
  bool hidden = false;
  glm::vec3 jumpedAt{0.0f};  ///< LabelRequest::towardsEye when it last jumped
  bool operator==(const PlacedLabel&) const = default;
};

/// Left out for now, after a jump there.
struct WaitingLabel {
  model::AnnotationId id;
  glm::vec3 jumpedAt{0.0f};
  bool operator==(const WaitingLabel&) const = default;
};

struct LabelLayout {
  std::vector<PlacedLabel> labels;           ///< in the order of the items
  std::vector<model::AnnotationId> leftOut;  ///< for which there was no room
  std::vector<WaitingLabel> waiting;         ///< of those, who was there while the camera turned
  std::array<float, 2> edges{};              ///< of the left and the right column
  std::array<float, 2> widths{};             ///< of the widest that has stood in each
  float textWidth = 0.0f;                    ///< LabelRequest::textWidth
  bool operator==(const LabelLayout&) const = default;

  const PlacedLabel* find(model::AnnotationId id) const;
};

/// Holds for every answer: no two boxes overlap, no two leaders cross, no leader runs through a
/// box, its own or another's, or turns by more than a right angle, no box but one moved by hand
/// covers its own dot or the line that it measures, all boxes lie within the space, and nothing of
/// them lies where it is reserved, but for leaders to what was moved by hand. What was moved by
/// hand stays where it was put and the others give way: in their column, to the other side, or they
/// are left out. What finds no place is left out: what is hidden before what is seen, later items
/// before earlier ones. The same request and the same layout before give the same layout.
LabelLayout layOutLabels(const LabelRequest& request, const LabelLayout* before = nullptr);

}  // namespace sline::render
