// SPDX-License-Identifier: Apache-2.0
// Measures whether a picture is a plate (METHOD §12, proof): most of its subject is seen, little of
// the sheet is ink, and some of it has colour.
#pragma once

#include <span>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/raster/image.h"

namespace sline::render {

/// Holds shares, 0 … 1.
struct PlateProof {
  double subjectSeen = 0.0;  ///< of the subject's own silhouette, what no filled context hides
  double ink = 0.0;          ///< of the sheet, what is darker than a third of white
  double coloured = 0.0;     ///< of the sheet, what has a hue that one sees
  bool holds() const;
};

/// What a plate must have.
inline constexpr double leastSubjectSeen = 0.6;
inline constexpr double mostInk = 0.1;
inline constexpr double leastColoured = 0.03;

/// The height in pixels at which plates are drawn for their proof.
inline constexpr int plateHeight = 1200;

/// Measures the picture, which shows the scene from that camera. Structures that are nothing but
/// lines hide nothing; sections are not regarded.
PlateProof plateProof(const model::Scene& scene, const model::Camera& camera,
                      std::span<const model::NodeId> subject, const Image& picture);

/// Draws the scene on white at `plateHeight`, in a context of its own, and measures that.
Result<PlateProof> plateProof(const model::Scene& scene, const model::Camera& camera,
                              std::span<const model::NodeId> subject, float aspect);

}  // namespace sline::render
