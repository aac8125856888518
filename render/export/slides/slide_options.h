// SPDX-License-Identifier: Apache-2.0
// Declares the options of slides.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

enum class SlideShape { wide, standard };

struct SlideOptions {
  SlideShape shape = SlideShape::wide;
  bool onClick = false;   ///< labels appear one by one, in their order
  bool selfTest = false;  ///< a slide with numbers instead of names follows, then its key
};

OptionList slideOptions();

extern const ExportOption slideShapeOption;

}  // namespace sline::render
