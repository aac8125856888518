// SPDX-License-Identifier: Apache-2.0
// Words and marks that point at the anatomy.
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

/// A place on a structure's surface: it goes where the structure goes, through every edit that
/// keeps the mesh.
struct SurfacePoint {
  NodeId structure;
  std::uint32_t triangle = 0;
  /// Barycentric weights of the triangle's second and third corner, each ≥ 0 and together ≤ 1; the
  /// first corner has the rest.
  std::array<float, 2> weights{};
  bool operator==(const SurfacePoint&) const = default;
};

/// A place on a surface, or one in space (LPS, millimetres).
using Anchor = std::variant<glm::vec3, SurfacePoint>;

/// `label` stands beside its place, `callout` away from it with a leader, `pin` marks the place
/// itself, `distance` measures from its first place to its second.
enum class AnnotationKind { label, callout, pin, distance };

struct Annotation {
  AnnotationId id;
  AnnotationKind kind = AnnotationKind::label;
  std::vector<Anchor> anchors;               ///< as many as anchorCount(kind)
  std::string text;                          ///< in the language of the scene
  std::map<std::string, std::string> texts;  ///< in other languages, by BCP 47 tag ("la")
  std::optional<Colour> colour;              ///< absent: the ink's
  bool visible = true;                       ///< where a view does not say which are shown
  bool locked = false;                       ///< not to be moved by hand
  /// Moved by hand: from its place (a distance's middle) to the middle of its text, to the right
  /// and downwards, in heights of the picture; so it goes along where the picture is printed
  /// larger.
  std::optional<glm::vec2> offset;
  std::string unread;  ///< as Node::unread
  bool operator==(const Annotation&) const = default;
};

/// How many places the kind has: 2 for a distance, else 1.
std::size_t anchorCount(AnnotationKind kind);
/// In the language, else the scene's own.
const std::string& textIn(const Annotation& annotation, const std::string& language);
/// LPS, millimetres. The point's triangle must be one of the mesh.
glm::vec3 placeOn(const Mesh& mesh, const SurfacePoint& point);
/// What makes an annotation unusable whatever scene it is in, for an error message.
std::optional<std::string_view> annotationFault(const Annotation& annotation);

}  // namespace sline::model
