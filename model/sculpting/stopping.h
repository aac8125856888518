// SPDX-License-Identifier: Apache-2.0
// Giving up in the middle of modelling. All of its time goes into asking fields, so it is enough
// that they refuse to answer; the refusal ends what is made of one structure, and then in `demo`.
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

/// Throws ModellingStopped where stop was asked for.
inline void goOnUnless(const std::stop_token& stop) {
  if (stop.stop_requested())
    throw ModellingStopped();
}

/// The same field as long as nobody asks to stop, then ModellingStopped.
inline Field stoppable(Field field, const std::stop_token& stop) {
  if (!stop.stop_possible() || !field)
    return field;
  return [field = std::move(field), stop](const glm::vec3& p) {
    goOnUnless(stop);
    return field(p);
  };
}

}  // namespace sline::model
