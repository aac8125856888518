// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the visible structures as a binary glTF 2.0 file (.glb): groups and structures are nodes
/// under one that turns LPS millimetres into metres with +y up; colours and opacity are materials.
/// Annotations that are shown are nodes, and saved views are cameras; whatever else Sline knows
/// about them is in extras. Surfaces are whole where sections cut the picture. Progress may stop it
/// (`givenUp`).
Result<std::string> glbBytes(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
