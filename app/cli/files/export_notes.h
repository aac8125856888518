// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/order/export_notes.h"

namespace sline::cli {

/// Returns the note and what to do about it, in flags of `sline export`: "3 labels found no room:
/// \"liver\" … Take a larger page …". It is one line, whatever the names are.
std::string textOf(const render::ExportNote& note);
/// Returns the note alone, for commands without those flags.
std::string factOf(const render::ExportNote& note);

}  // namespace sline::cli
