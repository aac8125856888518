// SPDX-License-Identifier: Apache-2.0
// 3D Slicer's scene file (.mrml, XML; Slicer 3, 4 and 5): which models it shows, where their files
// are, their colours, places and hierarchy. Only the scene itself is read, not the copies of it
// that its saved views hold.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/import/raw_mesh.h"
#include "model/scene/style.h"

namespace sline::model {

struct SlicerGroup {
  std::string name;
  std::optional<std::size_t> parent;  ///< index of an earlier group
  Style style;
};

struct SlicerModel {
  std::string name;
  std::filesystem::path file;  ///< exists
  std::optional<std::size_t> group;
  Style style;
  std::optional<glm::dmat4> toWorld;  ///< RAS → RAS, millimetres; parents' transforms included
  Frame frame = Frame::ras;           ///< of the file, unless the file's own header says another
  std::string frameReason;
};

struct SlicerScene {
  std::vector<SlicerGroup> groups;  ///< parents first
  std::vector<SlicerModel> models;  ///< in the scene's order
  std::size_t named = 0;            ///< models with a file, whether or not it is there
  std::vector<ImportWarning> warnings;
};

/// Broken XML or a file that is no scene is an error; models whose file is absent, lies outside the
/// scene's folder or hangs on a cycle of references are left out or untransformed, with a warning.
Result<SlicerScene> readSlicerScene(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
