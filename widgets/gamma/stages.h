// SPDX-License-Identifier: Apache-2.0
// Lists the stages that Γ passes through, by the names that the user reads.
#pragma once

#include <QString>
#include <vector>

#include "model/base/units.h"

namespace sline::widgets {

struct Stage {
  float gamma;
  QString name;
  QString explanation;
};

/// Returns the stages from 0 to 5, one at each whole number.
std::vector<Stage> gammaStages();

/// Returns Γ as a text such as "3.25".
QString gammaText(Gamma gamma);

}  // namespace sline::widgets
