// SPDX-License-Identifier: Apache-2.0
// Lists the flags that set a number of a style, as a table: a new one is a row here. How they are
// declared, read and carried out follows from it.
#pragma once

#include <span>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/style.h"

namespace sline::cli {

struct StyleFlag {
  const char* flag = "";   ///< "--pen"
  const char* value = "";  ///< what is typed after it: "[NAME=]W"
  const char* help = "";
  const char* what = "";  ///< the number's name in errors
  /// Reads a number within the field's limits and returns a style that sets this one field.
  Result<model::Style> (*parse)(std::string_view what, std::string_view text) = nullptr;
};

/// Returns the flags in the order in which the user should meet them.
std::span<const StyleFlag> styleFlags();

}  // namespace sline::cli
