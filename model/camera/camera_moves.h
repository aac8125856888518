// SPDX-License-Identifier: Apache-2.0
// Computes how the mouse moves the camera: cameras in, cameras out, no window. Pixels count from
// the picture's upper left corner, y downwards.
#pragma once

#include <glm/vec2.hpp>
#include <limits>
#include <optional>

#include "model/camera/camera.h"
#include "model/geometry/bvh.h"

namespace sline::model {

/// Turns the camera around the pivot as if the scene stood on a turntable that can be tilted:
/// `turnDegrees` about the body's long axis (positive: the scene's near side goes to the right),
/// `tiltDegrees` about the picture's horizontal (positive: the near side goes down), which stops
/// where the scene is seen from straight above or below. A level horizon stays level.
Camera orbited(const Camera& camera, const glm::vec3& pivot, float turnDegrees, float tiltDegrees);
/// Moves the camera so that what lies as deep as `at` follows the mouse by that many pixels of a
/// picture that is `height` pixels high.
Camera panned(const Camera& camera, const glm::vec3& at, const glm::vec2& pixels, float height);
/// Magnifies the scene by `factor` around the point, which keeps its place in the picture.
Camera zoomed(const Camera& camera, const glm::vec3& at, float factor);

/// The least and the greatest height that a picture shows where it is zoomed, mm.
struct ZoomEnds {
  float least = 0.0f;
  float greatest = std::numeric_limits<float>::infinity();
};
/// Returns the ends for a scene that is visible within these bounds: from where all of it is a
/// speck to where little more can be told apart, by eyes or by floats.
ZoomEnds zoomEnds(const Box& visible);
/// Magnifies likewise, no farther than to the ends, at the depth of the point. From beyond an end
/// it goes back only.
Camera zoomedWithin(const Camera& camera, const glm::vec3& at, float factor, const ZoomEnds& ends);

/// Returns the camera with a picture so many times as high; the middle shows the same in the same
/// size if the picture is that many times as high, too.
Camera withHeight(Camera camera, float times);

/// Turns the picture about its middle, by degrees clockwise.
Camera rolled(const Camera& camera, float degrees);
/// Turns the camera around the pivot, which keeps its place in the picture, until it looks from the
/// direction `from`, with `up` upwards; neither needs unit length.
Camera turnedTo(const Camera& camera, const glm::vec3& pivot, const glm::vec3& from,
                const glm::vec3& up);

/// Returns the line of sight through a pixel; its direction is a unit vector.
Ray sightThrough(const Camera& camera, const glm::vec2& pixel, const glm::vec2& size);
/// Returns the point where the line of sight through the pixel reaches the depth of `at`.
glm::vec3 pointAtDepthOf(const Camera& camera, const glm::vec3& at, const glm::vec2& pixel,
                         const glm::vec2& size);
/// Returns the pixel of a point; absent for one that is not in front of the eye.
std::optional<glm::vec2> pixelOf(const Camera& camera, const glm::vec3& p, const glm::vec2& size);

/// A drag of the camera, from the press of a button to its release.
class CameraDrag {
 public:
  enum class Kind { orbit, pan, zoom, roll };
  struct Start {
    Kind kind = Kind::orbit;
    glm::vec2 pixel{0.0f};
    Camera camera;
    glm::vec3 pivot{0.0f};
    ZoomEnds ends;
  };
  explicit CameraDrag(const Start& start) : m_start(start) {}
  /// Returns the camera for the mouse at that pixel, which depends on where the drag began, not on
  /// the path.
  Camera at(const glm::vec2& pixel, const glm::vec2& size) const;

 private:
  Start m_start;
};

}  // namespace sline::model
