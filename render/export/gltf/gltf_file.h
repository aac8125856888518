// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes the visible structures as one .glb file, as `glbBytes` makes it, whole or not at all.
Status writeGltf(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

/// Notes what no such file has: cuts, which its extras describe.
ExportNotes gltfNotes(const ExportOrder& order);

/// Returns about how many bytes the file takes: what its surfaces do, and the usual of each
/// structure's description.
double gltfWeight(const ExportOrder& order);

}  // namespace sline::render
