// SPDX-License-Identifier: Apache-2.0
// Checks the files that commands write: names are refused, before anything is read or written, if
// what lies there would be lost or the file would not be what its name says.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"

namespace sline::cli {

/// Describes a file or folder that is to be written.
struct Target {
  std::string flag;  ///< as typed: "--png"
  std::string name;
  std::vector<std::string> endings;  ///< of its kind, without dots, the usual one first
  bool folder = false;
  bool scene = false;  ///< it is a scene file, which may take the place of one that is read
};

/// Returns the targets of `sline export`, from names by the kinds' ids.
std::vector<Target> exportTargets(const std::map<std::string, std::string>& byKind);

/// Fails for a target that
/// - has no name, or the name "-";
/// - is one of the files `read` (scene, mesh, camera …), through links too, or one that the
///   importer finds in a folder of them;
/// - ends with .sline, unless it is a scene;
/// - ends like another kind of file than its own. A name without an ending, or with one that no
///   kind has, is written as it stands, and so is any existing target that is not a plain file (a
///   pipe, /dev/stdout);
/// - is the same file as another one (except /dev/null).
/// Texts in `read` that name no file do not matter. An error counts as wrong use.
Status checkTargets(std::span<const Target> targets, std::span<const std::string> read);

}  // namespace sline::cli
