// SPDX-License-Identifier: Apache-2.0
// Decides where labels stand in a picture, with one layout for the window, pixels, vectors and
// print. Labels and callouts stand in two columns beside the anatomy (column.h), pins and distances
// beside their own place where there is room. While a camera turns, each layout starts from the one
// before, and whatever can stay stays: sides, order and columns change only where they must or
// where much is gained, and a label that has jumped rests for the next 20° where others can give
// way (after Ali, Hartmann and Strothotte: Label layout for interactive 3D illustrations. Journal
// of the WSCG 13, 2005).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "model/scene/annotation.h"
#include "render/labels/obstacles.h"
#include "render/labels/seen/shapes.h"

namespace sline::render {

struct SeenArea;

/// Tells where a label stands; `beside` means beside its place, without a leader.
enum class LabelPost { left, right, beside, byHand };

struct LabelItem {
  model::AnnotationId id;
  model::AnnotationKind kind = model::AnnotationKind::label;
  std::vector<glm::vec2> places;  ///< millimetres of the output; one place, two for a distance
  bool hidden = false;  ///< something, perhaps its own structure, is in front of the place
  bool focus = false;   ///< it names what is in focus, and is the last to be left out
  glm::vec2 box{0.0f};  ///< the size that the text needs, with its padding
  float seen = 0.0f;    ///< of a label: how much the picture shows of what it names, if known
  /// Where the place was found for this picture; absent where it was set by hand.
  std::optional<model::Anchor> found;
  /// Set for a label moved by hand: the way from its base to the box's middle.
  std::optional<glm::vec2> offset;
  /// Where the annotation's own place is in this picture: a box moved by hand stays with it while
  /// leaders end at places that are found. Absent: its place.
  std::optional<glm::vec2> base;
  /// Set where it is known on which side the label stands in all pictures of a film: in that
  /// column, or nowhere.
  std::optional<LabelPost> side;
  /// Set where it is known how high the label stands in all pictures of a film: the box's middle.
  std::optional<float> height;
  bool absent = false;  ///< it is known that it stands nowhere in this picture of a film
};

/// Describes the output, in millimetres.
struct LabelSpace {
  glm::vec2 size{0.0f};
  float sideMargin = 0.0f;  ///< beyond the left and right side, where boxes may also stand
  EdgeRoom edges;           ///< the room where no box stands
  /// Areas taken by something else, without boxes or leaders.
  std::vector<LabelBox> reserved;
};

struct LabelRequest {
  std::vector<LabelItem> items;  ///< each id once
  LabelSpace space;
  ObstacleMask obstacles;
  /// The unit vector from the scene to the eye; tells how far the camera has turned since a label
  /// jumped.
  glm::vec3 towardsEye{0.0f};
  /// The camera is moving: a label that has just jumped does not jump again, but is left out where
  /// there is no other way, until the camera rests or has turned 20°.
  bool moving = false;
  /// The picture is one of a film: labels of columns stand at `LabelItem::height` or nowhere, and
  /// only leaders are chosen; columns follow the anatomy's extent.
  bool still = false;
  std::array<float, 2> widths{};  ///< in a film, of the left and the right column
  float textWidth = 0.0f;         ///< the width to which texts were broken; kept for later layouts
  /// What the picture shows, if labels of columns must keep off it; null where they lie over
  /// anatomy rather than be left out, as while one works with the picture. In a film it counts for
  /// nothing, as heights are planned.
  const SeenArea* drawn = nullptr;
};

struct PlacedLabel {
  model::AnnotationId id;
  LabelPost post = LabelPost::left;
  LabelBox box;
  Leader leader;  ///< empty where none is needed
  bool hidden = false;
  glm::vec3 jumpedAt{0.0f};            ///< LabelRequest::towardsEye when it last jumped
  std::optional<model::Anchor> found;  ///< LabelItem::found
  int number = 0;                      ///< that of its badge, where labels are numbered
  std::size_t bend = 0;                ///< in a film, which of the ways to bend its leader has
  bool operator==(const PlacedLabel&) const = default;
};

/// A label that is left out for now, after it jumped at `jumpedAt`.
struct WaitingLabel {
  model::AnnotationId id;
  glm::vec3 jumpedAt{0.0f};
  bool operator==(const WaitingLabel&) const = default;
};

struct LabelLayout {
  std::vector<PlacedLabel> labels;           ///< in the order of the items
  std::vector<model::AnnotationId> leftOut;  ///< those for which there was no room
  std::vector<WaitingLabel> waiting;         ///< those of them that have jumped before
  std::array<float, 2> edges{};              ///< of the left and the right column
  std::array<float, 2> widths{};             ///< of the widest box that has stood in each
  float textWidth = 0.0f;                    ///< LabelRequest::textWidth
  /// Where all labels would stand if none had been moved by hand, as one layout; empty where none
  /// has. Others give way from there, and come back.
  std::vector<LabelLayout> unmoved;
  bool operator==(const LabelLayout&) const = default;

  const PlacedLabel* find(model::AnnotationId id) const;
};

/// Returns the layout for the same camera in an output of another size, as one before the next:
/// sides and order are as they were, and what is moved by hand.
LabelLayout resized(const LabelLayout& layout, const glm::vec2& from, const glm::vec2& to);

/// Lays out the labels. Every layout satisfies this: no two boxes overlap, no two leaders cross, no
/// leader passes another's dot, runs through a box, its own or another's, or turns by more than a
/// right angle, no box but one moved by hand covers its own dot or the line that it measures, all
/// boxes lie within the space, no part of them lies where it is reserved, except leaders to labels
/// moved by hand, and no box of a column lies over what is drawn, where that is known. A label
/// moved by hand stays where it was put and the others stand as if it had not been, except
/// those that would collide: they give way by as little as helps, with a bend of the leader, in
/// their column, to the other side, or they are left out. Labels that find no place are left out:
/// hidden ones before seen ones, names of what the picture shows less of before others (twice as
/// much counts), later items before earlier ones. The same request and the same
/// layout before give the same layout.
LabelLayout layOutLabels(const LabelRequest& request, const LabelLayout* before = nullptr);

/// Returns pairs of items, by their index, that cannot both stand in a picture of a film; an item
/// that cannot stand by itself is paired with itself.
std::vector<std::pair<std::size_t, std::size_t>> labelConflicts(const LabelRequest& request);

}  // namespace sline::render
