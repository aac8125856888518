// SPDX-License-Identifier: Apache-2.0
// Tells what an element's symbol stands for: radii and conventional colour.
#pragma once

#include <string_view>

#include "model/base/units.h"

namespace sline::model {

struct Element {
  std::string_view symbol;   ///< as written: "Fe"
  std::string_view name;     ///< "iron"
  float vanDerWaals = 2.0f;  ///< Å: Bondi, J. Phys. Chem. 68, 1964; where he has none, Mantina et
                             ///< al., J. Phys. Chem. A 113, 2009 (main groups), else 2.0
  float covalent = 1.5f;     ///< Å, single bond: Cordero et al., Dalton Trans. 2008
  Colour colour;             ///< after Corey, Pauling and Koltun, toned for paper
};

/// Returns the element by its symbol, case ignored ("FE", "Fe"); deuterium is hydrogen. Null where
/// there is no such element.
const Element* elementOf(std::string_view symbol);
/// Returns the stand-in for an unknown element: 2.0 Å, grey.
const Element& unknownElement();

}  // namespace sline::model
