// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene_file/journal.h"

namespace sline::model {

/// Returns what the journal of a recovered document says of the one that it takes the place of, as
/// a member of the rest with which it is started: as long as that one is there it has more, and
/// this one is not found.
ZipMember successionOf(const Recoverable& left);

}  // namespace sline::model
