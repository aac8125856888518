// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <filesystem>
#include <vector>

namespace sline::widgets {

/// Why the files cannot be written there and what to do, before anybody tries; empty where nothing
/// is known to be in the way. A disk may still turn out to be full.
QString targetProblem(const std::vector<std::filesystem::path>& targets);

/// Those that are there already, by their names without folders. What is no plain file is not
/// replaced by being written to.
QStringList existingFiles(const std::vector<std::filesystem::path>& targets);

}  // namespace sline::widgets
