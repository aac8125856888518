// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/scene_migration.h"

#include "model/scene_json/scene_json.h"

namespace sline::model {

Status migrate(Json& root) {
  const int schema = TRY(schemaOf(root));
  if (schema < sceneSchema)
    return Error{.where = "schema",
                 .reason = "nothing leads from schema " + std::to_string(schema) + " to " +
                           std::to_string(sceneSchema)};
  return Unit{};
}

}  // namespace sline::model
