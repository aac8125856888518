// SPDX-License-Identifier: Apache-2.0
// Defines the words and marks that point at the anatomy.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/base/units.h"
#include "model/geometry/mesh.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// Names an annotation for as long as the scene lives, through every edit and through undo.
struct AnnotationId {
  std::uint64_t value = 0;
  auto operator<=>(const AnnotationId&) const = default;
};

/// Holds a place on a structure's surface: it moves with the structure through every edit that
/// keeps the mesh.
struct SurfacePoint {
  NodeId structure;
  std::uint32_t triangle = 0;
  /// The barycentric weights of the triangle's second and third corner, each ≥ 0 and together ≤ 1;
  /// the first corner has the rest.
  std::array<float, 2> weights{};
  bool operator==(const SurfacePoint&) const = default;
};

/// Holds a place on a surface, or one in space (LPS, millimetres).
using Anchor = std::variant<glm::vec3, SurfacePoint>;

/// A `label` stands beside its place, a `callout` away from it with a leader, a `pin` marks the
/// place itself, and a `distance` measures from its first place to its second.
enum class AnnotationKind { label, callout, pin, distance };

struct Annotation {
  AnnotationId id;
  AnnotationKind kind = AnnotationKind::label;
  std::vector<Anchor> anchors;               ///< anchorCount(kind) places; on cuts: cut_place.h
  std::string text;                          ///< in the language of the scene
  std::map<std::string, std::string> texts;  ///< in other languages, by BCP 47 tag ("la")
  std::optional<Colour> colour;              ///< absent: the ink's colour
  bool visible = true;  ///< whether it is shown where a view does not list the annotations to show
  bool locked = false;  ///< true: it cannot be moved by hand
  /// The program has found its place and finds it anew in each picture that does not show the
  /// structure there; false: the place was set by hand and stays.
  bool found = false;
  /// Set when moved by hand: the offset from its place (a distance's middle) to the middle of its
  /// text, to the right and downwards, in heights of the picture; so it scales with the picture
  /// when printed larger.
  std::optional<glm::vec2> offset;
  std::string unread;  ///< like Node::unread
  bool operator==(const Annotation&) const = default;
};

/// Returns how many places the kind has: 2 for a distance, else 1.
std::size_t anchorCount(AnnotationKind kind);
/// Returns the text in the language, or the scene's own text where there is none.
const std::string& textIn(const Annotation& annotation, const std::string& language);
/// Returns the place of the point in LPS, millimetres. The point's triangle must belong to the
/// mesh.
glm::vec3 placeOn(const Mesh& mesh, const SurfacePoint& point);
/// Returns what makes an annotation unusable in any scene, for an error message.
std::optional<std::string_view> annotationFault(const Annotation& annotation);

}  // namespace sline::model
