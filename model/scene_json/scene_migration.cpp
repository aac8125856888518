// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/scene_migration.h"

#include "model/scene_json/scene_json.h"

namespace sline::model {

Status migrate(Json& root) {
  const Result<int> schema = schemaOf(root);
  if (!schema.ok())
    return schema.error();
  if (*schema < sceneSchema)
    return Error{.where = "schema",
                 .reason = "nothing leads from schema " + std::to_string(*schema) + " to " +
                           std::to_string(sceneSchema)};
  return Unit{};
}

}  // namespace sline::model
