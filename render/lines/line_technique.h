// SPDX-License-Identifier: Apache-2.0
// Lists the techniques that find lines on surfaces in a table, which pictures, vector drawings,
// `sline lines` and the layers of SVG files go through. A new technique is a file with its
// functions, a kind in lines.h and a row in line_technique.cpp.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/base/units.h"
#include "render/lines/chains.h"
#include "render/lines/cluster_walk.h"
#include "render/lines/lines.h"

namespace sline::render {

/// Tells how a pen draws lines of a kind.
enum class LinePen {
  outside,  ///< beside the line, where the surface ends
  centred,  ///< on the line, where the surface continues on both sides
  cutEdge   ///< on the line, in front of the faces that meet there; half of it stays at Γ = 5
};

/// Pairs the numbers that lines were found with and their names in `sline lines`.
using LineFigures = std::vector<std::pair<const char*, float>>;

struct LineTechnique {
  LineKind kind = LineKind::contour;
  const char* id = "";     ///< for `sline lines --kinds`
  const char* layer = "";  ///< in vector drawings: "Contours"
  LinePen pen = LinePen::centred;
  Specks specks;         ///< times the style's shortest line
  bool atScale = false;  ///< found on the forms that are large enough in the picture (line_scale.h)
  bool bounds = false;   ///< fills are softened along these lines, so they are always found
  /// Returns the T by which lines of the kind have entered at Γ, 0 … 1 (METHOD §7).
  float (*entered)(Gamma gamma) = nullptr;
  /// Returns whether a line may pass through the cluster, judged by its bounds before its vertices
  /// are looked at. Null: the technique's lines do not come from the surface.
  bool (*mayPass)(const model::Cluster& cluster, model::Facing facing) = nullptr;
  /// Appends the cluster's segments.
  void (*extract)(const ClusterWalk& walk, const LineRequest& request,
                  std::vector<Segment>& segments) = nullptr;
  /// Leaves out lines that their own surface always hides and replaces entries by ranks, so that
  /// lines enter evenly with `t`, which `entered` gave. Null: all enter at once.
  void (*rank)(std::vector<Segment>& segments, const model::Surface& surface,
               const model::Camera& camera, float t) = nullptr;
  /// Returns the thresholds at Γ; null where there are none.
  LineFigures (*figures)(Gamma gamma) = nullptr;
};

/// Returns the techniques in the order of `LineKind`.
std::span<const LineTechnique> lineTechniques();

inline const LineTechnique& techniqueOf(LineKind kind) {
  return lineTechniques()[std::size_t(kind)];
}

}  // namespace sline::render
