// SPDX-License-Identifier: Apache-2.0
// Imports files as they are, without smoothing.
#pragma once

#include <QTemporaryDir>
#include <filesystem>
#include <optional>
#include <vector>

#include "model/import/plan/import.h"

namespace sline::test {

Result<model::Imported> importOf(const std::vector<std::filesystem::path>& inputs,
                                 std::optional<model::Frame> frame = {});

std::filesystem::path inFolder(const QTemporaryDir& folder, const char* name);

}  // namespace sline::test
