// SPDX-License-Identifier: Apache-2.0
// The techniques that find lines on surfaces, as a table: pictures, vector drawings, `sline lines`
// and the layers of SVG files walk it. A new one is a file with its functions, a kind in lines.h
// and a row in line_technique.cpp.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/base/units.h"
#include "render/lines/cluster_walk.h"
#include "render/lines/lines.h"

namespace sline::render {

/// How a pen sets lines of a kind.
enum class LinePen {
  outside,  ///< beside the line, where the surface ends
  centred,  ///< on the line, where the surface goes on at both sides
  cutEdge   ///< on the line, before the faces that meet there; half of it stays at Γ = 5
};

/// Marks shorter than `shortest` λ fade away, and are there in full from `whole` λ on. Zeros: none
/// does.
struct Specks {
  float shortest = 0.0f;
  float whole = 0.0f;
};

/// Numbers that lines were found with, by their names in `sline lines`.
using LineFigures = std::vector<std::pair<const char*, float>>;

struct LineTechnique {
  LineKind kind = LineKind::contour;
  const char* id = "";     ///< of `sline lines --kinds`
  const char* layer = "";  ///< of vector drawings: "Contours"
  LinePen pen = LinePen::centred;
  Specks specks;
  bool bounds = false;  ///< fills are softened along these lines: they are found whatever is drawn
  /// Returns the T by which lines of the kind have entered at Γ, 0 … 1 (METHOD §7).
  float (*entered)(Gamma gamma) = nullptr;
  /// Returns whether a line may pass in the cluster: judged by its bounds, before its vertices are
  /// looked at. Null: the technique's lines come from elsewhere than the surface.
  bool (*mayPass)(const model::Cluster& cluster, model::Facing facing) = nullptr;
  /// Appends the cluster's segments.
  void (*extract)(const ClusterWalk& walk, const LineRequest& request,
                  std::vector<Segment>& segments) = nullptr;
  /// Leaves out what its own surface always hides and replaces entries by ranks, so that lines
  /// enter evenly with `t`, which `entered` gave. Null: all enter at once.
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
