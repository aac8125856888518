// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/scene/camera.h"
#include "widgets/session/document_file.h"

namespace sline::widgets {

/// Where a scene was looked at from when it was saved. It is no part of the scene, as turning it is
/// no edit; it goes along as a member of its own, "workspace.json", which other programs keep.
model::ZipMember memberFor(const model::Camera& camera);
/// Nothing where the file says none that a picture can be taken from.
std::optional<model::Camera> cameraIn(const DocumentFile& file);

}  // namespace sline::widgets
