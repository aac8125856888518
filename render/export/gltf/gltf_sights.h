// SPDX-License-Identifier: Apache-2.0
// Cameras, saved views, annotations and sections of a scene in glTF: as nodes and cameras where
// glTF knows such a thing, with the rest in their extras (glTF 2.0 §3.11).
#pragma once

#include <map>

#include "model/scene/scene.h"
#include "render/export/gltf/gltf_json.h"

namespace sline::render {

/// Which node of the file is which of the scene.
using GltfNodes = std::map<model::NodeId, std::size_t>;

/// Of a surface or a whole: what is said of how it is drawn and glTF has no word for.
Json styleExtras(const model::ResolvedStyle& style);

/// A camera of the file; `bounds` (LPS, millimetres) is all that it may see.
Json gltfCamera(const model::Camera& camera, const model::Box& bounds);
/// Where it stands, as members of its node: in metres, outside of the node that turns the scene.
Json cameraPlace(const model::Camera& camera);

/// What a saved view says beside its camera: the looks of the nodes that are in the file.
Json viewExtras(const model::Scene& scene, const model::View& view, const GltfNodes& nodes);
/// The scene's node for an annotation: its first place as translation (LPS, millimetres), all
/// places, texts and kind as extras. Its anchors must be in the scene.
Json annotationNode(const model::Scene& scene, const model::Annotation& annotation,
                    const std::string& language);
/// Planes that cut the picture; surfaces in the file are whole.
Json sectionExtras(const model::Section& section);

}  // namespace sline::render
