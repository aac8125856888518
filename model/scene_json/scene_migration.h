// SPDX-License-Identifier: Apache-2.0
// Brings older versions of scene.json to this one.
#pragma once

#include "model/base/result.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Brings `root` to the schema that is written today; one of a newer schema stays as it is. Schema
/// 1 is the first, so there is nothing to change yet: a step from one schema to the next belongs
/// here once there are two, and a file of the older one in tests/model/scene_file/examples.
Status migrate(Json& root);

}  // namespace sline::model
