// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/camera/camera.h"
#include "widgets/session/document_file.h"

namespace sline::widgets {

/// Returns the camera from which a scene was last seen, as a member for its file. It is no part of
/// the scene, as turning it is no edit; it is saved as a member of its own, "workspace.json", which
/// other programs keep.
model::ZipMember memberFor(const model::Camera& camera);
/// Returns the camera; none where the file has no camera that a picture can be taken from.
std::optional<model::Camera> cameraIn(const DocumentFile& file);

}  // namespace sline::widgets
