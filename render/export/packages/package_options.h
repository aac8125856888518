// SPDX-License-Identifier: Apache-2.0
// Declares the options of what learning systems are given. Which kinds of questions there are is
// chosen as for the students' page.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

struct PackageOptions {
  double passing = 50.0;  ///< percent of right answers from which on it is passed
};

/// Which questions with pictures there are.
struct QuestionKinds {
  bool find = true;    ///< asks where something is
  bool name = true;    ///< asks what something is called, to be typed
  bool choose = true;  ///< asks the same, with names to choose from

  bool any() const { return find || name || choose; }
};
QuestionKinds questionKinds(const ExportOrder& order);

/// Returns the options of questions with pictures.
OptionList questionOptions();
/// Returns those, and from what share of right answers on a set of them is passed.
OptionList questionSetOptions();
/// Returns the options of a package of the students' page.
OptionList pagePackageOptions();

}  // namespace sline::render
