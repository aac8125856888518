// SPDX-License-Identifier: Apache-2.0
// The files that commands write: names are refused, before anything is read or written, where what
// lies there would be lost or the file would not be what its name says.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"

namespace sline::cli {

/// A file or folder that is to be written.
struct Target {
  std::string flag;  ///< as typed: "--png"
  std::string name;
  std::vector<std::string> endings;  ///< of its kind, without dots, the usual one first
  bool folder = false;
  bool scene = false;  ///< it is a scene file, which may well take the place of one that is read
};

/// Those of `sline export`, by the kinds' ids.
std::vector<Target> exportTargets(const std::map<std::string, std::string>& byKind);

/// Fails for a target that
/// - has no name, or the name "-";
/// - is one of the files `read` (scene, mesh, camera …), through links too, or one that the
///   importer finds in a folder of them;
/// - ends with .sline, but for a scene;
/// - ends like another kind of file than its own. A name without an ending, or with one that no
///   kind has, is written as it stands, and so is what exists and is no plain file (a pipe,
///   /dev/stdout);
/// - is the same file as another one (but /dev/null).
/// Texts in `read` that name no file do not matter. An error is a wrong use.
Status checkTargets(std::span<const Target> targets, std::span<const std::string> read);

}  // namespace sline::cli
