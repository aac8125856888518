// SPDX-License-Identifier: Apache-2.0
// Makes the guide's page about speed and memory out of reports.
#pragma once

#include <filesystem>
#include <span>

#include "model/base/result.h"

namespace sline::bench {

/// Reads reports as `sline-bench --json` prints them, in the order given, each named as its file,
/// and writes the page with its tables, and beside it NAME/growth.png: times over triangles of
/// those named like the first one but for a number at the end, on logarithmic scales.
Status writePerformancePage(const std::filesystem::path& page,
                            std::span<const std::filesystem::path> reports);

}  // namespace sline::bench
