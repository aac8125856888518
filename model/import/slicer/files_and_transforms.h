// SPDX-License-Identifier: Apache-2.0
// Finds the files of the nodes of a .mrml scene, and the transforms that apply to them. Private to
// the reader.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/import/slicer/nodes.h"
#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Tells whether the relative path stays in the folder that it is relative to.
bool staysInside(const std::filesystem::path& relative);

/// Returns the file that a node of the scene calls `written`, if it is there and inside the scene's
/// folder; else nothing, with a warning.
std::optional<std::filesystem::path> fileOfSlicer(const std::filesystem::path& scene,
                                                  const std::string& written,
                                                  std::vector<ImportWarning>& warnings);

class SlicerTransforms {
 public:
  /// `file` is the scene's name, for warnings. All must outlive this object.
  SlicerTransforms(const SlicerNodes& nodes, std::string file, std::vector<ImportWarning>& warnings)
      : m_nodes(nodes), m_file(std::move(file)), m_warnings(warnings) {}

  /// Returns the RAS → RAS transform in millimetres of all transforms above the node; nothing where
  /// there are none or they cannot be used (with a warning). `name` is the name of the node in the
  /// warning.
  std::optional<glm::dmat4> above(const XmlNode& node, const std::string& name);

 private:
  /// Holds the combined transform of a node and all above it; absent where one cannot be used, and
  /// then `fault` says why unless that was reported already.
  struct World {
    std::optional<glm::dmat4> matrix;
    std::string fault;
  };
  /// Returns the combined transform. Each transform is looked at once, however much hangs below it.
  const World& worldOf(const std::string& id);
  std::optional<glm::dmat4> ownMatrix(const XmlNode& transform) const;
  void warn(std::string reason) const { m_warnings.push_back({m_file, std::move(reason)}); }

  const SlicerNodes& m_nodes;
  std::string m_file;
  std::vector<ImportWarning>& m_warnings;
  std::unordered_map<std::string, World> m_worlds;  ///< by id
};

}  // namespace sline::model
