// SPDX-License-Identifier: Apache-2.0
// Tells which structures a legend lists, and by what names legends, keys and lists know them.
#pragma once

#include <string>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/labels/anchors.h"

namespace sline::render {

/// Returns the visible structures that such a legend lists, in the order of the scene: all, those
/// that a shown label points at, or those in focus; not what sections take away wholly. Other lists
/// have none.
std::vector<const model::Node*> legendStructures(const model::Scene& scene, LegendList list);

/// Returns the name in the language (a BCP 47 tag, or several as in "de+la"), if it is known in it.
std::string structureName(const std::string& name, const std::string& language);
/// Returns the name of the node so; one that is in doubt carries a mark (known_frame.h).
std::string structureName(const model::Node& node, const std::string& language);

/// Returns what a distance leads from and to, "portal vein – tumour", as far as its ends are on
/// structures; empty for other annotations.
std::string distanceEnds(const model::Scene& scene, const model::Annotation& annotation,
                         const std::string& language);
/// Returns what a key says of the label (label_texts.h): a distance without words of its own says
/// what it leads from and to.
std::string keyLine(const model::Scene& scene, const ShownLabel& label, const LabelStyle& style);

}  // namespace sline::render
