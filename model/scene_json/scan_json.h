// SPDX-License-Identifier: Apache-2.0
// Writes and reads the scans of a scene in scene.json, except their voxels, to which scene.json
// refers by name.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/scan.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Maps the names that scene.json uses to voxels.
using VoxelsByName = std::map<std::string, VoxelsPtr, std::less<>>;

/// Says of what is there and cannot be read, by its name, why.
using DamagedByName = std::map<std::string, std::string, std::less<>>;
/// Returns why there is nothing of that name.
std::string absenceOf(const std::string& name, const DamagedByName& damaged,
                      std::string_view otherwise);

/// Returns the name of the n-th scan's voxels, n from 0.
std::string voxelsName(std::size_t n);
/// Returns the scan as JSON with keys in the order of the description, without the scan's unread
/// keys.
nlohmann::ordered_json scanJson(const Scan& scan, const std::string& voxels);
/// Returns the names of the voxels to which scene.json refers.
std::vector<std::string> voxelsCalledFor(const Json& root);
/// Returns the scans and notes what is wrong in the value's fault.
std::vector<Scan> scansFrom(const JsonValue& list, const VoxelsByName& voxels,
                            const DamagedByName& damaged);

}  // namespace sline::model
