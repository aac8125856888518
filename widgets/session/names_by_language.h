// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "widgets/session/display_names.h"

namespace sline::widgets {

/// Returns what the structure is called in each language, by BCP 47 tag; empty where the table does
/// not know the name.
std::map<std::string, std::string> namesByLanguage(const DisplayNames& names,
                                                   const std::string& name);

}  // namespace sline::widgets
