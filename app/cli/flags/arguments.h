// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sline::cli {

/// How many values an option takes.
enum class Values {
  one,         ///< or none
  several,     ///< --only Bones bladder
  assignments  ///< --gamma liver=4 aorta=5; the first may be for all, --gamma 2
};

struct ArgumentKinds {
  std::function<Values(const std::string& option)> valuesOf;
  std::function<bool(const std::string& path)> exists;  ///< whether it is a file or folder
};

/// Inputs may stand anywhere. Options that take several values would swallow an input that follows
/// them, so what cannot be one of their values is moved to the front: from the second value on
/// whatever exists as a file or folder, and of assignments anything without '='. `arguments` start
/// with the sub-command's name.
std::vector<std::string> withInputsFirst(const std::vector<std::string>& arguments,
                                         const ArgumentKinds& kinds);

}  // namespace sline::cli
