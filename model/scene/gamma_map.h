// SPDX-License-Identifier: Apache-2.0
// Lets Γ vary over one surface (METHOD §7): Γ(p) = Γ of the structure + offset(scalar(p)), so that
// a single mesh can run from silhouette to shading.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// Says what Γ follows: nothing, how much of its own sky the surface hides (0 … 1), its mean
/// curvature times F (1 on a sphere, negative in hollows), the distance to other structures (mm),
/// or what a person has painted there (Node::paint, 0 … 1).
enum class GammaScalar { none, occlusion, curvature, distance, painted };
inline constexpr std::array<std::string_view, 5> gammaScalarNames{"none", "occlusion", "curvature",
                                                                  "distance", "painted"};

/// Says by how much Γ differs from the structure's where the scalar has that value.
struct GammaPoint {
  float scalar = 0.0f;
  float offset = 0.0f;  ///< −5 … 5
  bool operator==(const GammaPoint&) const = default;
};

inline constexpr std::size_t fewestGammaPoints = 2;
inline constexpr std::size_t mostGammaPoints = 8;
inline constexpr std::size_t mostGammaTargets = 1000;
inline constexpr Limits<float> gammaOffsets{-5.0f, 5.0f};
/// The scalars that a curve may name, whatever they mean.
inline constexpr Limits<float> gammaScalars{-1e6f, 1e6f};

struct GammaMap {
  GammaScalar scalar = GammaScalar::none;
  /// The structures and groups to which distances are measured, the nearest counts; of other
  /// scalars none. A map to nothing that is in the scene leaves Γ as it is.
  std::vector<NodeId> targets;
  /// A place to which distances are measured, too (LPS, millimetres).
  std::optional<glm::vec3> place;
  /// Points by ascending scalars, straight lines between them, level beyond the ends.
  std::vector<GammaPoint> curve;

  bool operator==(const GammaMap&) const = default;
  /// Returns by how much Γ differs where the scalar, a number or infinity, has that value.
  float offsetAt(float value) const;
};

/// Returns what makes a curve unusable, for an error message.
std::optional<std::string_view> curveFault(std::span<const GammaPoint> curve);
/// Returns what makes a map unusable, for an error message; a map of no scalar says nothing else.
std::optional<std::string_view> gammaMapFault(const GammaMap& map);

/// Returns the curve that a map by this scalar has until someone draws another: occlusion and
/// hollows raise Γ by 3, as does what lies within 10 mm of the targets, and from 40 mm on Γ is 1
/// less; what is painted raises Γ by 3.
std::vector<GammaPoint> usualCurve(GammaScalar scalar);

/// Reads "0:+3,40:-1", pairs of a scalar and an offset.
Result<std::vector<GammaPoint>> curveFromText(std::string_view text);
/// Writes the curve so that `curveFromText` reads the same.
std::string curveText(std::span<const GammaPoint> curve);

/// Returns a map part of the way from one to another, 0 … 1: curves of one kind of scalar become
/// each other; otherwise the one flattens before the other rises.
GammaMap between(const GammaMap& from, const GammaMap& to, float part);

}  // namespace sline::model
