// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <filesystem>
#include <vector>

namespace sline::widgets {

/// Returns why the files cannot be written there and what to do, before anything is tried; empty
/// where no obstacle is known. A disk may still turn out to be full.
QString targetProblem(const std::vector<std::filesystem::path>& targets);

/// Returns the targets that already exist, by their names without folders. Only plain files count,
/// because writing replaces nothing else.
QStringList existingFiles(const std::vector<std::filesystem::path>& targets);

}  // namespace sline::widgets
