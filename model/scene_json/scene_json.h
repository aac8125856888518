// SPDX-License-Identifier: Apache-2.0
// Writes and reads the scene as scene.json of a scene file (resources/help/scene_file.md): all of
// it but the meshes, what is painted on them and the scans' voxels, to which scene.json refers by
// name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "model/scene_json/json_value.h"
#include "model/scene_json/scan_json.h"

namespace sline::model {

/// The version of scene.json that this program writes.
inline constexpr int sceneSchema = 1;

/// What a scene.json may have: views of many structures say much. A scene beyond that is not
/// written.
inline constexpr JsonLimits sceneJsonLimits{.bytes = std::size_t(512) << 20, .values = 16'000'000};

/// Maps the names that scene.json uses to meshes, and to what is painted on them.
using MeshesByName = std::map<std::string, MeshPtr, std::less<>>;
using PaintsByName = std::map<std::string, PaintPtr, std::less<>>;

/// Holds what scene.json refers to.
struct SceneParts {
  MeshesByName meshes;
  PaintsByName paints;
  VoxelsByName voxels;
  DamagedByName damaged = {};
};

/// Returns the name of each mesh, after the first structure that has it: a mesh that several
/// structures share has one name.
std::map<MeshPtr, std::string> meshNames(const Scene& scene);
/// Returns the name of what is painted on a structure.
std::string paintName(NodeId structure);

/// Returns scene.json with keys in the order of the description and the scene's unread keys after
/// them. Bytes of a name that are not UTF-8 become U+FFFD.
std::string sceneJson(const Scene& scene);

/// Returns the version of scene.json. The error says why this is no scene at all.
Result<int> schemaOf(const Json& root);
/// Returns the names of the meshes to which scene.json refers, each once, in order.
std::vector<std::string> meshesCalledFor(const Json& root);
/// Does the same for what is painted.
std::vector<std::string> paintsCalledFor(const Json& root);

/// Returns the scene; keys without a meaning here are kept in it. A value that a newer schema has
/// put in place of a known one (an unknown fill) is kept unread as well; in a file of this schema
/// it is an error, as is what a scene may not hold. An error's `where` is the place:
/// "nodes[3].style.gamma".
Result<Scene> sceneFromJson(const Json& root, const SceneParts& parts);
/// Does the same but leaves out what is at fault, the smallest thing that can be, and adds what and
/// why; `where` begins with a name then: "\"Liver\" (nodes[3].style.gamma)". It is an error only
/// where there is no list of nodes, or all is in another frame or unit. A structure without its
/// mesh stays as a group in which there is nothing.
Result<Scene> sceneFromJson(const Json& root, const SceneParts& parts,
                            std::vector<JsonRefusal>& leftOut);

}  // namespace sline::model
