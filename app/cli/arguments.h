// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sline::cli {

/// Inputs may stand anywhere. Options that take several values (--gamma liver=4 aorta=5, --only
/// Bones bladder) would swallow an input that follows them, so what cannot be one of their values
/// is moved to the front: for --gamma and --color anything without '=' after the first value, for
/// --only whatever `exists` as a file or folder. `arguments` start with the sub-command's name.
std::vector<std::string> withInputsFirst(const std::vector<std::string>& arguments,
                                         const std::function<bool(const std::string&)>& exists);

}  // namespace sline::cli
