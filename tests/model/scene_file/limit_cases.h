// SPDX-License-Identifier: Apache-2.0
// Makes scenes with a value at a limit of what a scene may hold, and beyond it, for every field
// that has one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::test {

/// Puts a value into a scene, which is a sample scene.
using Put = std::function<void(model::Scene&)>;

struct LimitCase {
  std::string field;
  std::string value;    ///< "1001 bytes"
  bool within = false;  ///< a scene may hold it
  bool slow = false;    ///< there are very many of something
  /// A build with assertions makes no such scene: the value is one of a section, label or scan.
  bool asserted = false;
  Put put;
};

/// Returns all cases: of each field at least one within its limits and one beyond.
std::vector<LimitCase> limitCases();

}  // namespace sline::test
