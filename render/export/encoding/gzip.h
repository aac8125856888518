// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace sline::render {

/// Returns the bytes in gzip's format (RFC 1952), as small as it makes them, without name and date.
std::string gzipped(std::string_view bytes);

}  // namespace sline::render
