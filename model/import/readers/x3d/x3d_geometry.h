// SPDX-License-Identifier: Apache-2.0
// Turns the geometry of nodes into faces.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "model/import/readers/x3d/x3d_document.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

/// Says how the corners of a geometry make faces.
enum class CornerRuns { polygons, triangles, quads, strips, fans };
struct X3dGeometry {
  std::string_view type;
  CornerRuns runs;
  std::string_view corners;  ///< the field with indices; empty: all points in turn
  std::string_view counts;   ///< the field that says how many of them make a strip or fan
};
inline constexpr std::array<X3dGeometry, 9> x3dGeometries{
    {{"IndexedFaceSet", CornerRuns::polygons, "coordIndex", ""},
     {"IndexedTriangleSet", CornerRuns::triangles, "index", ""},
     {"IndexedQuadSet", CornerRuns::quads, "index", ""},
     {"IndexedTriangleStripSet", CornerRuns::strips, "index", ""},
     {"IndexedTriangleFanSet", CornerRuns::fans, "index", ""},
     {"TriangleSet", CornerRuns::triangles, "", ""},
     {"QuadSet", CornerRuns::quads, "", ""},
     {"TriangleStripSet", CornerRuns::strips, "", "stripCount"},
     {"TriangleFanSet", CornerRuns::fans, "", "fanCount"}}};

/// Returns the faces of a geometry with that many points.
FaceList facesIn(const X3dNode& node, const X3dGeometry& kind, std::size_t points);

}  // namespace sline::model
