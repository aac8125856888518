// SPDX-License-Identifier: Apache-2.0
// Reads the flag that names a drawing style (model/look/drawing_styles.h), and draws a scene so.
#pragma once

#include <string>

#include "app/cli/flags/picture_flags.h"
#include "model/look/drawing_styles.h"

namespace sline::cli {

/// Returns the styles' ids with that text between them.
std::string drawingNames(const std::string& between);
/// Returns the help of the flag: each style with its description.
std::string drawingHelp();

/// Reads the style, and the background where no other is given, into the spec.
Status parseDrawing(const PictureFlags& flags, PictureSpec& spec);
/// Returns the scene in the style of the order, if it has one; sections of the order count.
Result<model::Scene> inDrawingStyle(const model::Scene& scene, const PictureSpec& spec);

}  // namespace sline::cli
