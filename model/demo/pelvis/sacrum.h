// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/sculpting/sculpture.h"

namespace sline::model {

/// Models a man's sacrum with the coccyx (pelvis demo's frame, LPS, mm): wings, promontory, four
/// pairs of foramina that pass through, median and lateral crests, canal and hiatus.
Sculpture sacrum();

}  // namespace sline::model
