// SPDX-License-Identifier: Apache-2.0
// Computes fingerprints of files: enough to see that a file has changed, but no protection against
// forgery.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::model {

Fingerprint fingerprintOf(std::string_view bytes);
/// Returns the file's fingerprint, reading the file piece by piece.
Result<Fingerprint> fingerprintOfFile(const std::filesystem::path& file);

}  // namespace sline::model
