// SPDX-License-Identifier: Apache-2.0
// Where a structure came from, as it stands in scene.json (resources/help/scene_file.md).
#pragma once

#include "model/scene/scene.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Takes how sure the sides are, as "sides" and "front" say; what they do not say is as given.
SideEvidence evidenceFrom(JsonObject& object, SideEvidence unsaid);
/// Puts that where it is not as a reader takes it unsaid.
void putEvidence(nlohmann::ordered_json& json, const SideEvidence& evidence,
                 const SideEvidence& unsaid);
/// Takes what the object says of a structure's origin.
Provenance provenanceFrom(JsonObject& object);
/// Returns it in the order of the description.
nlohmann::ordered_json provenanceJson(const Provenance& provenance);

}  // namespace sline::model
