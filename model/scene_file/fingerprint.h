// SPDX-License-Identifier: Apache-2.0
// Fingerprints of files: enough to see that one has changed, not to keep anybody from forging one.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::model {

Fingerprint fingerprintOf(std::string_view bytes);
/// Reads the file piece by piece.
Result<Fingerprint> fingerprintOfFile(const std::filesystem::path& file);

}  // namespace sline::model
