// SPDX-License-Identifier: Apache-2.0
// Declares the options of questions that learning systems ask.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

struct PackageOptions {
  bool find = true;    ///< asks where something is
  bool name = true;    ///< asks what something is called, to be typed
  bool choose = true;  ///< asks the same, with names to choose from
};

OptionList questionOptions();

/// Tells whether there is any kind of question at all.
bool hasQuestions(const PackageOptions& options);

}  // namespace sline::render
