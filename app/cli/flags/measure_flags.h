// SPDX-License-Identifier: Apache-2.0
// Declares what the measuring sub-commands share: which structures of which scene, seen from where.
#pragma once

#include <string>
#include <vector>

#include "app/cli/files/progress.h"
#include "app/cli/flags/picture_flags.h"
#include "app/cli/flags/scene_input.h"
#include "model/base/result.h"
#include "render/measures/subject.h"

namespace sline::cli {

/// Holds the flags as typed.
struct MeasureFlags {
  InputFlags input;
  std::vector<std::string> structures;
  bool all = false;
  std::string view = "anterior";
  std::string cameraFile;
  std::string size = "640x480";
  bool json = false;
  bool check = false;
};

/// Holds the scene that was read and what was asked about it.
struct MeasureSpec {
  model::Scene scene;
  std::vector<model::NodeId> structures;  ///< at least one
  PictureSpec picture;                    ///< camera or view, and size
};

/// Reads the flags and the scene. `wrongUse` tells the kinds of errors apart.
Result<MeasureSpec> readMeasureSpec(const MeasureFlags& flags, Progress& progress, bool& wrongUse);

/// Returns the structure alone, seen from the order's camera; an anatomical view is fitted to it.
/// An error counts as wrong use.
Result<render::Subject> subjectOf(const MeasureSpec& spec, model::NodeId structure);

}  // namespace sline::cli
