// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace sline::cli {

/// Tells whether the text names a language as BCP 47 does: "de", "nb", "zh-Hant", "de-AT-1996".
bool isLanguageTag(std::string_view tag);

}  // namespace sline::cli
