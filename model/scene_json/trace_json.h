// SPDX-License-Identifier: Apache-2.0
// Writes and reads what a scene keeps of where it came from.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "model/scene/source_trace.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Returns the trace without its unread keys.
nlohmann::ordered_json traceJson(const SourceTrace& trace);

/// Returns the traces of the list that can be compared.
std::vector<SourceTrace> tracesFrom(const JsonValue& list);

}  // namespace sline::model
