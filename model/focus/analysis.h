// SPDX-License-Identifier: Apache-2.0
// What every structure is to those in focus, from the meshes alone: how near it lies, what of them
// it hides, whether it is a vessel that comes to them. Names play no part. How much of it is then
// drawn is another question (model/focus/context.h), so that it can be asked again and again.
//
// Giving structures importance and letting it decide how densely each is drawn is Viola, Kanitsar,
// Gröller, "Importance-Driven Volume Rendering" (2004), where a person gives it; here it is worked
// out.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/focus/form.h"
#include "model/scene/scene.h"

namespace sline::model {

enum class ContextRole {
  target,
  feeder,     ///< a vessel or duct that comes to a target, or the stem that such a one comes from
  neighbour,  ///< lies beside a target
  shell,      ///< lies outside, around or before a target, and hides it
  backdrop,   ///< the rest: far off and out of the way
};

/// What decided a structure's role.
enum class RoleReason {
  chosen,
  reaches,    ///< thin, long and comes to a target
  feedsStem,  ///< thin, long and comes to what reaches a target (`through`)
  touches,
  near,
  hides,
  far,
};

/// Lengths are in units of the targets' size: of the radius of a sphere with as much surface.
struct Relation {
  NodeId structure;
  ContextRole role = ContextRole::backdrop;
  RoleReason reason = RoleReason::far;
  NodeId through;      ///< for `feedsStem`
  float gapMm = 0.0f;  ///< from surface to surface
  float gap = 0.0f;
  float contact = 0.0f;   ///< share of the targets' surface that it lies against
  float feeding = 0.0f;   ///< 0 … 1
  float nearness = 0.0f;  ///< 1 where it touches … 0 far off
  /// Share of the targets that it hides from the camera; without one, from where it hides most.
  float hides = 0.0f;
  float outside = 0.0f;  ///< 0 amid the targets … 1 where the scene ends
  float size = 0.0f;     ///< radius of the sphere around it
};

struct FocusAnalysis {
  std::vector<NodeId> targets;      ///< structures, in tree order
  std::vector<Relation> relations;  ///< one for each structure, in tree order
  bool fromCamera = false;
};

struct FocusQuestion {
  std::span<const NodeId> targets;  ///< structures and groups
  std::optional<Camera> camera;     ///< absent: from all round
};

/// Absent where stop was asked for, or where nothing in focus has a surface. Sections count: what
/// they take away hides nothing. Mirrored scenes give the mirrored answer; the order of structures
/// and the size of triangles change nothing of note.
std::optional<FocusAnalysis> analysed(const Scene& scene, const FocusQuestion& question,
                                      FormIndex& forms, const std::stop_token& stop = {});

}  // namespace sline::model
