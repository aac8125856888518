// SPDX-License-Identifier: Apache-2.0
// Measures what a picture is compared with, and what is done with a scene besides turning it.
#pragma once

#include <filesystem>

#include "model/base/result.h"
#include "tests/bench/report.h"
#include "tests/bench/stage.h"

namespace sline::bench {

Status measurePhong(const Stage& stage, Report& report);
/// Measures VTK in a context of its own, since VTK relies on a fresh one's state.
Status measureVtk(const Stage& stage, Report& report);
/// Measures a vector drawing from the front, on a page of the picture's shape.
Status measureVectors(const Stage& stage, Report& report);
/// Measures drags of the Γ of four structures; a scene of one has none to compare with.
Status measureDrag(render::Picture& picture, const Stage& stage, Report& report);
/// Saves the scene to a file that goes again, and reads it.
Status measureReopening(const Stage& stage, Report& report);

/// Writes the scene's structures as one surface, each subdivided so often, as a PLY file.
Status writeSubdivided(const model::Scene& scene, int times, const std::filesystem::path& file);

}  // namespace sline::bench
