// SPDX-License-Identifier: Apache-2.0
// The scene as scene.json of a scene file (resources/help/scene_file.md) and back: all of it but
// the meshes and the scans' voxels, which it names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "model/scene_file/json_value.h"
#include "model/scene_file/scan_json.h"

namespace sline::model {

/// The version of scene.json that this program writes.
inline constexpr int sceneSchema = 1;

/// Meshes by the names under which scene.json calls for them.
using MeshesByName = std::map<std::string, MeshPtr, std::less<>>;

/// The name each structure's mesh goes under, of the first structure that has it: one mesh that
/// several structures share has one name.
std::map<MeshPtr, std::string> meshNames(const Scene& scene);

/// Keys in the order of the description, what the scene has kept unread after them. Bytes of a name
/// that are no UTF-8 become U+FFFD.
std::string sceneJson(const Scene& scene);

/// Which version wrote it. The error says why this is no scene at all.
Result<int> schemaOf(const Json& root);
/// The names of the meshes that it calls for, each once, in order.
std::vector<std::string> meshesCalledFor(const Json& root);

/// The scene; keys without a meaning here are kept in it. What a newer schema has put in place of a
/// known value (a fill that is unknown) is kept unread as well; in a file of this schema it is an
/// error. An error's `where` is the place: "nodes[3].style.gamma".
Result<Scene> sceneFromJson(const Json& root, const MeshesByName& meshes,
                            const VoxelsByName& voxels = {});

}  // namespace sline::model
