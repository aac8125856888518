// SPDX-License-Identifier: Apache-2.0
// The scans of a scene as scene.json has them: all but their voxels, which it names.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/scene/scan.h"
#include "model/scene_file/json_value.h"

namespace sline::model {

/// Voxels by the names under which scene.json calls for them.
using VoxelsByName = std::map<std::string, VoxelsPtr, std::less<>>;

/// The name of the n-th scan's voxels, n from 0.
std::string voxelsName(std::size_t n);
/// Keys in the order of the description; what a scan has kept unread is not among them.
nlohmann::ordered_json scanJson(const Scan& scan, const std::string& voxels);
/// The names of the voxels that scene.json calls for.
std::vector<std::string> voxelsCalledFor(const Json& root);
/// Notes what is wrong in the value's fault.
std::vector<Scan> scansFrom(const JsonValue& list, const VoxelsByName& voxels);

}  // namespace sline::model
