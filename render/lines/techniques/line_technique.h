// SPDX-License-Identifier: Apache-2.0
// Lists the techniques that find lines on surfaces in a table, which pictures, vector drawings,
// `sline lines` and the layers of SVG files go through. A new technique is a file with its
// functions, a kind in lines.h and a row in line_technique.cpp. If styles choose it, its name is a
// value of `model::Technique`.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/base/units.h"
#include "model/scene/style.h"
#include "render/lines/ground/chains.h"
#include "render/lines/ground/cluster_walk.h"
#include "render/lines/techniques/line_preparations.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// Tells how a pen draws lines of a kind.
enum class LinePen {
  outside,  ///< beside the line, where the surface ends
  centred,  ///< on the line, where the surface continues on both sides
  cutEdge   ///< on the line, in front of the faces that meet there; half of it stays at Γ = 5
};

/// Describes a limit where lines of a kind may be.
struct LineThreshold {
  const char* id = "";       ///< in `sline lines`
  const char* meaning = "";  ///< in English, with its unit: F and F_c make lengths dimensionless
  float usual = 0.0f;
  Limits<float> limits;
  /// It grows where lines are found on forms that were smoothed more than usual (line_scale.h).
  bool grows = false;
};

/// Where lines of a kind that comes from the surface as a whole are looked for.
struct LineSearch {
  const model::Surface& surface;
  const model::Camera& camera;
  const LineRequest& request;
  const PreparedLines* prepared = nullptr;  ///< null where the technique prepares nothing
};

struct LineTechnique {
  LineKind kind = LineKind::contour;
  const char* id = "";     ///< for `sline lines --kinds`
  const char* layer = "";  ///< in vector drawings: "Contours"
  /// The technique of a style that draws lines of this kind; empty: each of them does.
  std::optional<model::Technique> drawnBy = std::nullopt;
  LinePen pen = LinePen::centred;
  Specks specks;         ///< times the style's shortest line
  bool atScale = false;  ///< found on the forms that are large enough in the picture (line_scale.h)
  bool bounds = false;   ///< fills are softened along these lines, so they are always found
  bool joined = true;    ///< a pen goes on where lines continue each other
  std::span<const LineThreshold> thresholds = {};  ///< at most `LineThresholds::most`
  /// Sets those of the thresholds that Γ decides. Null: it decides none.
  void (*setThresholds)(Gamma gamma, LineThresholds& thresholds) = nullptr;
  /// Returns the T by which lines of the kind have entered at Γ, 0 … 1 (METHOD §7).
  float (*entered)(Gamma gamma) = nullptr;
  /// Returns whether a line may pass through the cluster, which faces the eye like that: judged by
  /// its bounds before its vertices are looked at. Null: none of the technique's lines come from
  /// clusters.
  bool (*mayPass)(const model::Cluster& cluster, model::Facing facing,
                  const model::EyePoint& eye) = nullptr;
  /// Appends the cluster's segments.
  void (*extract)(const ClusterWalk& walk, const LineRequest& request,
                  std::vector<Segment>& segments) = nullptr;
  /// Computes what all views of a surface share.
  std::unique_ptr<const PreparedLines> (*prepare)(const model::Surface& surface) = nullptr;
  /// Appends the segments of the whole surface: instead of `mayPass` and `extract`, or what they
  /// do not find.
  void (*find)(const LineSearch& search, std::vector<Segment>& segments) = nullptr;
  /// Replaces entries by ranks, so that lines enter evenly with `t`, which `entered` gave. Null:
  /// all enter at once.
  void (*rank)(std::vector<Segment>& segments, const model::Surface& surface,
               const model::Camera& camera, float t) = nullptr;
};

/// Returns the techniques in the order of `LineKind`.
std::span<const LineTechnique> lineTechniques();

/// Returns the thresholds of all kinds as they are at Γ.
LineThresholds thresholdsAt(Gamma gamma);

inline const LineTechnique& techniqueOf(LineKind kind) {
  return lineTechniques()[std::size_t(kind)];
}

}  // namespace sline::render
