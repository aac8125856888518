// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/lettering/typesetting.h"
#include "render/picture/picture.h"

namespace sline::bench {

struct KeptPlate {
  std::string path;  ///< of a PNG file
  int height = 900;  ///< pixels; the width follows from the order's page
};

/// Draws the order with all that is written in it, so that what was counted can be looked at.
Status keepPlate(render::Picture& picture, const render::ExportOrder& order,
                 const render::Typesetting& typesetting, const KeptPlate& kept);

}  // namespace sline::bench
