// SPDX-License-Identifier: Apache-2.0
// Analyses how every structure relates to those in focus: from the meshes how near it lies, how
// much of them it hides, whether it is a vessel that comes to them; from the names what it is made
// of and which structures belong together. How much of it is then drawn is a separate question
// (model/focus/context.h), so that it can be answered again and again.
//
// Giving structures importance and letting it decide how densely each is drawn is from Viola,
// Kanitsar, Gröller, "Importance-Driven Volume Rendering" (2004), where a person gives it; here it
// is computed.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/anatomy/tissue.h"
#include "model/focus/form.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Says what decided a structure's role.
enum class RoleReason {
  chosen,
  reaches,    ///< thin, long and comes to a target
  supplies,   ///< a vessel named after a target, which it feeds or drains (`through`)
  feedsStem,  ///< thin, long and the origin of a vessel that reaches a target (`through`)
  touches,
  near,
  hides,
  far,
};

/// Describes how a structure relates to the targets. Lengths are in units of the targets' size: the
/// radius of a sphere with the same surface area.
struct Relation {
  NodeId structure;
  Tissue tissue = Tissue::unknown;
  ContextRole role = ContextRole::backdrop;
  RoleReason reason = RoleReason::far;
  NodeId through;      ///< the vessel between, for `feedsStem`; the target, for `supplies`
  float gapMm = 0.0f;  ///< from surface to surface
  float gap = 0.0f;
  float contact = 0.0f;   ///< share of the targets' surface that it lies against
  float feeding = 0.0f;   ///< 0 … 1
  float nearness = 0.0f;  ///< 1 where it touches … 0 far off
  /// The share of the targets that it hides from the camera or, without one or with several, from
  /// the side where it hides most.
  float hides = 0.0f;
  float outside = 0.0f;  ///< 0 amid the targets … 1 where the scene ends
  float size = 0.0f;     ///< radius of its bounding sphere
};

struct FocusAnalysis {
  std::vector<NodeId> asked;        ///< structures and groups, as the question had them
  std::vector<NodeId> targets;      ///< structures, in tree order
  std::vector<Relation> relations;  ///< one for each structure, in tree order
  std::optional<Camera> camera;     ///< that of the question
};

struct FocusQuestion {
  std::span<const NodeId> targets;    ///< structures and groups
  std::optional<Camera> camera;       ///< absent: seen from all round
  std::span<const Camera> turn = {};  ///< if any, seen from each of these instead
};

/// Returns the analysis; absent where stop was requested, or where nothing in focus has a surface.
/// Sections count: parts they take away hide nothing. Mirrored scenes give the mirrored answer; the
/// order of structures and the size of triangles have no noticeable effect.
std::optional<FocusAnalysis> analysed(const Scene& scene, const FocusQuestion& question,
                                      FormIndex& forms, const std::stop_token& stop = {});

}  // namespace sline::model
