// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a .mrml scene have their files, and which transforms lie over them. Private to
// the reader.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/import/raw_mesh.h"
#include "model/import/slicer_nodes.h"

namespace sline::model {

/// The file that a node of the scene calls `written`, if it is there and inside the scene's folder;
/// else nothing, with a warning.
std::optional<std::filesystem::path> fileOfSlicer(const std::filesystem::path& scene,
                                                  const std::string& written,
                                                  std::vector<ImportWarning>& warnings);

class SlicerTransforms {
 public:
  /// `file` is the scene's name, for warnings. All must outlive it.
  SlicerTransforms(const SlicerNodes& nodes, std::string file, std::vector<ImportWarning>& warnings)
      : m_nodes(nodes), m_file(std::move(file)), m_warnings(warnings) {}

  /// RAS → RAS, millimetres, of all transforms above the node; nothing where there are none or they
  /// cannot be used (with a warning). `name` is what the node is called in it.
  std::optional<glm::dmat4> above(const XmlNode& node, const std::string& name) const;

 private:
  std::optional<glm::dmat4> ownMatrix(const XmlNode& transform) const;
  void warn(std::string reason) const { m_warnings.push_back({m_file, std::move(reason)}); }

  const SlicerNodes& m_nodes;
  std::string m_file;
  std::vector<ImportWarning>& m_warnings;
};

}  // namespace sline::model
