// SPDX-License-Identifier: Apache-2.0
// Tells whose the files are that a reload would read.
#pragma once

#include "model/import/plan/patients.h"
#include "model/import/plan/reload.h"

namespace sline::model {

/// What a reload says of a file that it did not read for it.
inline constexpr const char* otherPatientNow = "it is of another patient than the other files now";

/// Compares the files that `reload` would read again with those that have not changed and with what
/// the scene knows of whose it is: nothing where all may be of one.
Patients patientsToReload(const Scene& scene, std::span<const std::filesystem::path> places,
                          const ReadOptions& options = {});

}  // namespace sline::model
