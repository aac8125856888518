// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sline::cli {

/// Says how many values an option takes.
enum class Values {
  one,         ///< one or none
  several,     ///< as in --only Bones bladder
  assignments  ///< as in --gamma liver=4 aorta=5; the first may be for all, as in --gamma 2
};

struct ArgumentKinds {
  std::function<Values(const std::string& option)> valuesOf;
  std::function<bool(const std::string& path)> exists;  ///< tells whether it is a file or folder
};

/// Returns the arguments in an order in which inputs may stand anywhere. Options that take several
/// values would swallow an input that follows them, so an argument that cannot be one of their
/// values is moved to the front: from the second value on every existing file or folder, and among
/// assignments anything without '='. `arguments` start with the sub-command's name.
std::vector<std::string> withInputsFirst(const std::vector<std::string>& arguments,
                                         const ArgumentKinds& kinds);

}  // namespace sline::cli
