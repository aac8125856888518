// SPDX-License-Identifier: Apache-2.0
// Stops in the middle of modelling. All of its time goes into reading fields, so it is enough that
// they throw; the exception ends the modelling of one structure, and then of the whole demo.
#pragma once

#include <exception>
#include <stop_token>
#include <utility>

#include "model/sculpting/implicit.h"

namespace sline::model {

class ModellingStopped : public std::exception {
 public:
  const char* what() const noexcept override { return "modelling was given up"; }
};

/// Throws ModellingStopped if stop was requested.
inline void goOnUnless(const std::stop_token& stop) {
  if (stop.stop_requested())
    throw ModellingStopped();
}

/// Returns a field that gives the same values until stop is requested, then throws
/// ModellingStopped.
inline Field stoppable(Field field, const std::stop_token& stop) {
  if (!stop.stop_possible() || !field)
    return field;
  return [field = std::move(field), stop](const glm::vec3& p) {
    goOnUnless(stop);
    return field(p);
  };
}

}  // namespace sline::model
