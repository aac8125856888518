// SPDX-License-Identifier: Apache-2.0
// Models hollow organs and long muscles: an elliptical cross-section carried along a smooth curve.
// The place of a point (how far along, on which side) lets a caller fold and swell the wall.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/sculpting/implicit.h"

namespace sline::model {

/// Holds a place on the centre line: half the width there, and half the depth as a share of it.
struct SweptPoint {
  glm::vec3 position;
  float radius;
  float depth = 1.0f;
};

/// Holds the place of a point relative to the nearest place on the centre line.
struct SweptCoordinates {
  float along = 0.0f;     ///< mm along the centre line
  float widths = 0.0f;    ///< the same length, counted in half widths passed
  float angle = 0.0f;     ///< angle around the centre line; 0 on the side of `front`, radians
  float distance = 0.0f;  ///< about the signed distance to the smooth wall, mm
  float radius = 1.0f;    ///< half the width here, mm
};

/// Describes a cross-section.
struct SweptRing {
  glm::vec3 position;  ///< on the centre line
  glm::vec3 front;     ///< unit vector, square to the line, where the angle is 0
  glm::vec3 side;      ///< unit vector, where the angle is a right angle
  float radius;        ///< half the width, mm
};

/// A body along a centripetal Catmull-Rom curve through the given points. The cross-section's depth
/// points to `front` at the start and is carried on without twist; the ends are rounded.
class Swept {
 public:
  Swept(std::span<const SweptPoint> through, const glm::vec3& front, float step = 2.0f);

  /// Returns the signed distance to the wall; from far away a lower bound.
  float distance(const glm::vec3& p) const { return place(p).distance; }
  SweptCoordinates place(const glm::vec3& p) const;

  SweptRing ring(float along) const;
  /// Returns about the distance from the point to the walls of stretches of the tube other than the
  /// point's own, at most `reach` mm.
  float distanceToOthers(const glm::vec3& p, const SweptCoordinates& at, float reach) const;

  float length() const { return m_samples.back().along; }
  const Box& bounds() const { return m_bounds; }
  /// Returns the box around the walls between two places along the centre line.
  Box bounds(float from, float to) const;
  /// Returns how far along the centre line its nearest place to the point lies.
  float alongNearest(const glm::vec3& p) const;
  /// Returns how far the point lies past the cut square to the centre line at `along`, mm; `at` is
  /// its place.
  float beyond(float along, const glm::vec3& p, const SweptCoordinates& at) const;

 private:
  struct Sample {
    glm::vec3 position{0.0f};
    float radius = 0.0f;
    float depth = 1.0f;
    float along = 0.0f;
    float widths = 0.0f;
    glm::vec3 front{0.0f};
  };
  /// Holds some successive segments (or runs of them) and the box around their walls.
  struct Run {
    std::size_t first, last;
    Box box;
  };
  struct Nearest {
    std::size_t segment = 0;
    float t = 0.0f;
    float distance = 0.0f;  ///< to a round wall
  };
  /// Holds the derivatives of the curve, per sample.
  struct Slopes {
    glm::vec3 tangent{0.0f};
    glm::vec3 bend{0.0f};  ///< second derivative
    float widening = 0.0f;
  };
  /// Returns the place at `s` samples from the start.
  Sample onCurve(float s, Slopes& slopes) const;
  /// Returns the distance to the boxes around parts of the wall: a lower bound.
  float distanceToRuns(const glm::vec3& p) const;
  void smooth();
  void carryFrames(const glm::vec3& front);
  void gatherRuns();
  void searchRun(const Run& run, const glm::vec3& p, Nearest& best) const;
  /// Returns the nearest segment, infinitely far where there is none within `reach`.
  Nearest nearest(const glm::vec3& p, float reach) const;

  std::vector<Sample> m_samples;
  std::vector<Run> m_runs;
  std::vector<Run> m_stretches;  ///< runs of runs
  Box m_bounds;
};

}  // namespace sline::model
