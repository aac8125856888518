// SPDX-License-Identifier: Apache-2.0
// A scene with things to ask for.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::test {

/// A label that would do harm if it were anything but text.
inline constexpr const char* hostileLabel = "<img src=x onerror=alert(1)> & ]]> \"*/:\\";

/// Returns an order that shows three balls with labels: "left kidney", also in Latin; one that is
/// hostile; "liver". A fourth, "spleen", lies hidden behind the liver.
render::ExportOrder askedOrder();

}  // namespace sline::test
