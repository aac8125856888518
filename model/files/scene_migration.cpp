// SPDX-License-Identifier: Apache-2.0
#include "model/files/scene_migration.h"

#include <algorithm>

#include "model/files/scene_json.h"

namespace sline::model {

std::span<const SceneMigration* const> sceneMigrations() {
  return {};
}

Status migrate(Json& root, std::span<const SceneMigration* const> migrations, int target) {
  for (;;) {
    const Result<int> schema = schemaOf(root);
    if (!schema.ok())
      return schema.error();
    if (*schema >= target)
      return Unit{};
    const auto step = std::find_if(migrations.begin(), migrations.end(),
                                   [&](const SceneMigration* m) { return m->from() == *schema; });
    if (step == migrations.end())
      return Error{.where = "schema",
                   .reason = "nothing leads from schema " + std::to_string(*schema) + " to " +
                             std::to_string(target)};
    if (Status applied = (*step)->apply(root); !applied.ok())
      return applied;
    root["schema"] = *schema + 1;
  }
}

}  // namespace sline::model
