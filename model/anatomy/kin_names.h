// SPDX-License-Identifier: Apache-2.0
// Tells by their names which structures belong together: the two of a pair, the members of a
// family.
#pragma once

#include <string>
#include <string_view>

#include "model/anatomy/name_words.h"

namespace sline::model {

/// Holds what a name says of the structure's kin; words are as `nameWords` gives them.
struct KinName {
  Side side = Side::none;
  std::string pair;    ///< the English name without its side
  std::string family;  ///< and without its numbers; empty where nothing else is left
};

/// Takes a name apart, in whatever language it is: "Rib6_left" → left, "rib 6 ", "rib ". Vertebrae
/// of all levels of the spine are one family, and so are its discs.
KinName kinName(std::string_view name);

}  // namespace sline::model
