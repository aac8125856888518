// SPDX-License-Identifier: Apache-2.0
// Declares the options that a picture has in every kind of file, and that of ink alone, which some
// kinds share.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

/// Returns background, labels and marks, in the order in which the user should meet them.
OptionList pictureOptions();
/// Returns the options for who made the picture, who may use it, what it shows and whose work the
/// surfaces are; all kinds have these.
OptionList creditOptions();

extern const ExportOption backgroundOption;
extern const ExportOption languageOption;
extern const ExportOption pureInkOption;

}  // namespace sline::render
