// SPDX-License-Identifier: Apache-2.0
// Writes cameras, saved views, annotations and sections of a scene to glTF: as nodes and cameras
// where glTF has these, with the rest in their extras (glTF 2.0 §3.11).
#pragma once

#include <map>

#include "model/scene/scene.h"
#include "render/export/gltf/gltf_json.h"

namespace sline::render {

/// Maps each node of the scene to its node in the file.
using GltfNodes = std::map<model::NodeId, std::size_t>;

/// Returns how a surface or a whole is drawn, as far as glTF has no terms for it.
Json styleExtras(const model::ResolvedStyle& style);

/// Returns a camera of the file; `bounds` (LPS, millimetres) is all that it may see.
Json gltfCamera(const model::Camera& camera, const model::Box& bounds);
/// Returns the camera's place as members of its node: in metres, outside the node that turns the
/// scene.
Json cameraPlace(const model::Camera& camera);

/// Returns what a saved view holds besides its camera: the looks of the nodes that are in the file.
Json viewExtras(const model::Scene& scene, const model::View& view, const GltfNodes& nodes);
/// Returns the scene's node for an annotation: its first place as translation (LPS, millimetres),
/// all places, texts and kind as extras. Its anchors must be in the scene.
Json annotationNode(const model::Scene& scene, const model::Annotation& annotation,
                    const std::string& language);
/// Describes the planes that cut the picture; surfaces in the file are whole.
Json sectionExtras(const model::Section& section);

}  // namespace sline::render
