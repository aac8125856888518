// SPDX-License-Identifier: Apache-2.0
// Tells which structures a legend lists, and by what names.
#pragma once

#include <string>
#include <vector>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the visible structures that such a legend lists, in the order of the scene: all, those
/// that a shown label points at, or those in focus. Other lists have none.
std::vector<const model::Node*> legendStructures(const model::Scene& scene, LegendList list);

/// Returns the name in the language (a BCP 47 tag, or several as in "de+la"), if it is known in it.
std::string structureName(const std::string& name, const std::string& language);

}  // namespace sline::render
