// SPDX-License-Identifier: Apache-2.0
// Where a structure came from, as it stands in scene.json (resources/help/scene_file.md).
#pragma once

#include "model/scene/scene.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Takes what the object says of a structure's origin.
Provenance provenanceFrom(JsonObject& object);
/// Returns it in the order of the description.
nlohmann::ordered_json provenanceJson(const Provenance& provenance);

}  // namespace sline::model
