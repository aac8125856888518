// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the credit as an XMP packet (ISO 16684-1) of Dublin Core's creator, rights and
/// description; empty
/// where there is none.
std::string xmpPacket(const ExportCredit& credit);

}  // namespace sline::render
