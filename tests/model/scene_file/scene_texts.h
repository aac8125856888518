// SPDX-License-Identifier: Apache-2.0
// Returns a scene's JSON and what it refers to by name.
#pragma once

#include "model/scene_json/scene_json.h"

namespace sline::test {

model::SceneParts partsByName(const model::Scene& scene);

model::Json jsonOf(const model::Scene& scene);

}  // namespace sline::test
