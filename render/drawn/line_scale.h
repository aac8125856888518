// SPDX-License-Identifier: Apache-2.0
// Lets lines of a technique see the surface at the picture's scale (METHOD §11.8): far away they
// follow its large forms, near by its small ones.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "model/geometry/surface.h"
#include "render/drawn/picture_view.h"

namespace sline::render {

/// One scale of a surface, and how much lines that are found there count, 0 … 1.
struct ScaledShape {
  model::SurfacePtr surface;  ///< its own triangles and positions, with normals and curvature of a
                              ///< copy without smaller forms
  float share = 1.0f;
  float threshold = 1.0f;  ///< times the usual least derivative: smoothed parts have false ones
};

/// Returns the deviation of the Gaussian, in mm, that takes out what is too small for lines in this
/// picture: `lineScale` times 4 λ, at most an eighth of F. `known` is the deviation of what the
/// surface has lost already; 0 is returned where that is enough.
float scaleDeviation(const model::Surface& surface, const PictureView& view, float lineScale,
                     float known);

/// Keeps the scales of a surface that pictures have asked for last. May be used from threads.
class LineScales {
 public:
  /// From now on forms are those of a finer mesh, which the surface stands for.
  void smooth(model::FinerMesh finer);
  /// Returns the shapes that lines are found on for that deviation: one, or two of which one fades
  /// out while the other comes in, as the deviation grows.
  std::vector<ScaledShape> at(const model::SurfacePtr& surface, float deviation);
  /// From now on nothing is made that takes long, as while the camera moves: where a scale is not
  /// known, the nearest that is stands in for it. False: all are made again.
  void hurry(bool hurried);
  /// Tells whether one stood in for another since `hurry` was called.
  bool lacks() const { return m_lacks; }

 private:
  model::SurfacePtr level(const model::SurfacePtr& surface, int level);
  bool knows(const std::vector<std::pair<int, float>>& wanted) const;
  ScaledShape nearest(const model::SurfacePtr& surface, float level) const;
  /// Returns the deviation of a level, and what its lines' least derivative is multiplied by.
  float deviationOf(const model::Surface& surface, int level) const;
  float thresholdOf(const model::Surface& surface, int level) const;

  model::FinerMesh m_finer;  ///< its mesh is null where the surface's own is the finest
  float m_finerEdge = 0.0f;  ///< mean, mm
  mutable std::mutex m_mutex;
  std::map<int, model::SurfacePtr> m_levels;
  std::atomic<bool> m_hurried = false;
  std::atomic<bool> m_lacks = false;
};

}  // namespace sline::render
