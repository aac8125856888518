// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/scene/camera.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns the anatomical view from which most of the structures' surface is seen, half with
/// bones and organs before them and half with themselves alone; anterior where no other shows a
/// fifth more (METHOD §12.6).
AnatomicalView bestViewOf(const Scene& scene, std::span<const NodeId> structures);

}  // namespace sline::model
