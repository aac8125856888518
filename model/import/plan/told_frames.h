// SPDX-License-Identifier: Apache-2.0
// Finds out what scenes of 3D Slicer say of files that are read without them.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "model/import/plan/sources.h"

namespace sline::model {

/// By what a scene may name a file: by its path alone, or also, where only one of the files is
/// called so, by its name. A scene in the folder above may be a stranger's, whose models were
/// called alike.
enum class NamedAs { path, name };

/// Scenes that may say of files which frame they are in.
struct ScenesBeside {
  std::vector<std::filesystem::path> files;
  NamedAs named = NamedAs::name;
};

/// Sets what the scenes say of those files that they name: scenes are moved, and their files with
/// them. Where scenes disagree none decides, and a warning says so. A scene that cannot be read
/// says nothing.
void tellFrames(std::span<SourceFile> files, ScenesBeside beside, const ReadLimits& limits,
                std::vector<ImportWarning>& warnings);

/// Returns the scenes in the folder or, where it has none, those in the folder above.
ScenesBeside scenesBeside(const std::filesystem::path& folder);

/// Returns the scenes of 3D Slicer in the folder, without those in folders of it.
std::vector<std::filesystem::path> scenesIn(const std::filesystem::path& folder);
/// Returns the folder that the folder lies in.
std::filesystem::path folderAbove(const std::filesystem::path& folder);

}  // namespace sline::model
