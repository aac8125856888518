// SPDX-License-Identifier: Apache-2.0
// Finds where an open surface ends: edges with one triangle, which are drawn as contours are
// (T. Isenberg et al., "A Developer's Guide to Silhouette Algorithms for Polygonal Models", 2003).
#pragma once

#include <memory>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

std::unique_ptr<const PreparedLines> prepareRims(const model::Surface& surface);
/// Appends the rims, with the direction in which the surface would go on as their normals.
void findRims(const LineSearch& search, std::vector<Segment>& segments);

}  // namespace sline::render
