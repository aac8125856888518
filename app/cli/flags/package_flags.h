// SPDX-License-Identifier: Apache-2.0
// Declares the flag that names a learning system's kind of file, and where that goes.
#pragma once

#include <map>
#include <string>

#include "model/base/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace sline::cli {

/// Holds the flags as typed.
struct PackageFlags {
  std::string kind;
  std::string file;
};

void declarePackage(CLI::App& command, PackageFlags& flags);
/// Adds `--package KIND -o FILE` as the kind that has a flag of its own; fails if that has a target
/// already, or if one flag is without the other.
Status addPackageTarget(const PackageFlags& flags, std::map<std::string, std::string>& targets);

}  // namespace sline::cli
