// SPDX-License-Identifier: Apache-2.0
// From older versions of scene.json to this one, a step at a time.
#pragma once

#include <span>

#include "model/base/result.h"
#include "model/files/json_value.h"

namespace sline::model {

/// Turns scene.json of one schema into that of the next. One class per schema that is no longer
/// written; a file of it is kept in tests/model/files/examples.
class SceneMigration {
 public:
  SceneMigration() = default;
  SceneMigration(const SceneMigration&) = delete;
  SceneMigration& operator=(const SceneMigration&) = delete;
  virtual ~SceneMigration() = default;

  /// The schema it starts from.
  virtual int from() const = 0;
  /// "schema" itself is set by `migrate`.
  virtual Status apply(Json& root) const = 0;
};

/// All there are; none so far, since schema 1 is the first.
std::span<const SceneMigration* const> sceneMigrations();

/// Brings `root` to schema `target`; what is of that schema or a newer one stays as it is.
Status migrate(Json& root, std::span<const SceneMigration* const> migrations, int target);

}  // namespace sline::model
