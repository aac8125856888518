// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_notes.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns what a drawing of vectors will lack: noise is found pixel by pixel.
ExportNotes drawingNotes(const ExportOrder& order);

}  // namespace sline::render
