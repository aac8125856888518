// SPDX-License-Identifier: Apache-2.0
// Reads a scene from JSON: its nodes and what belongs to it as a whole (scene_reader.cpp), and its
// sections, annotations and views (scene_parts_reader.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/scene/scene_limits.h"
#include "model/scene_json/scene_json.h"

namespace sline::model {

inline std::uint64_t idOf(const JsonValue& value) {
  return std::uint64_t(value.whole(1, std::int64_t(largestId)));
}

/// Where each fault is collected, what is at fault is left out: the smallest thing that can be, a
/// field where the rest makes sense without it. Else what is returned is of no use.
class SceneJsonReader {
 public:
  SceneJsonReader(const SceneParts& parts, bool newer) : m_parts(parts), m_newer(newer) {}

  Scene scene(const JsonValue& root);

 private:
  template <class Enum>
  std::optional<Enum> choice(JsonObject& object, std::string_view key,
                             std::span<const std::string_view> names) const {
    const std::optional<std::size_t> index = object.takeChoice(key, names, m_newer);
    return index ? std::optional(Enum(*index)) : std::nullopt;
  }
  MeshPtr mesh(JsonObject& object) const;
  void look(JsonObject& object, Node& node) const;
  /// Returns what is painted on the mesh.
  PaintPtr paint(JsonObject& object, const Mesh& mesh) const;
  Node node(const JsonValue& value) const;
  std::vector<Node> nodes(const JsonValue& list) const;
  Section section(const JsonValue& value) const;
  std::vector<Section> sections(const JsonValue& list) const;
  Annotation place(JsonObject& object) const;
  /// Returns nothing where it points nowhere.
  std::optional<Annotation> annotation(const JsonValue& value) const;
  std::vector<Annotation> annotations(const JsonValue& list, const std::vector<Node>& nodes) const;
  std::vector<Look> looks(const JsonValue& list) const;
  Focus focus(const JsonValue& value) const;
  /// Returns nothing where its camera sees nothing.
  std::optional<View> view(const JsonValue& value) const;
  std::vector<View> views(const JsonValue& list) const;

  const SceneParts& m_parts;
  bool m_newer;
};

}  // namespace sline::model
