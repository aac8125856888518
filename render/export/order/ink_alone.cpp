// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/ink_alone.h"

#include "model/edit/look.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

void leaveInkAlone(ExportOrder& order) {
  order.pureInk = true;
  order.labels.inColour = looksInColour(order.scene);
  order.scene = model::withInkAlone(order.scene).scene;
}

}  // namespace sline::render
