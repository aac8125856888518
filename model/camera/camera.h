// SPDX-License-Identifier: Apache-2.0
// Defines where the picture is taken from, in the patient frame LPS: +x to the patient's left, +y
// to the back, +z to the head; millimetres.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "model/geometry/mesh.h"

namespace sline::model {

enum class Projection { perspective, orthographic };

/// A right-handed camera looks along target − eye with `up` upwards in the picture.
struct Camera {
  Projection projection = Projection::perspective;
  glm::vec3 eye{0.0f, -1000.0f, 0.0f};
  glm::vec3 target{0.0f};
  glm::vec3 up{0.0f, 0.0f, 1.0f};
  float fovyDegrees = 30.0f;  ///< perspective: full vertical opening angle
  float heightMm = 200.0f;    ///< orthographic: the height that the picture shows

  bool operator==(const Camera&) const = default;
};

/// Lists the six directions from which anatomy is drawn; the name says which side of the patient is
/// seen. The head is up in the picture; seen from above or below, the front of the body is up. So
/// the patient's left is on the right of the picture in the anterior and the inferior view (as
/// radiologists hang CT slices), on the left in the posterior and the superior view; in the left
/// view the back of the body is on the right, in the right view on the left.
enum class AnatomicalView { anterior, posterior, left, right, superior, inferior };
inline constexpr std::array<std::string_view, 6> anatomicalViewNames{
    "anterior", "posterior", "left", "right", "superior", "inferior"};
std::optional<AnatomicalView> anatomicalViewNamed(std::string_view name);

/// Returns a perspective camera on that side of the box, fitted to its corners (see `fitted`).
/// `aspect` is width / height. An empty box gives the default camera, turned to that side.
Camera anatomicalCamera(AnatomicalView view, const Box& bounds, float aspect);
/// Returns the side that the camera sees, if it is upright as `anatomicalCamera` shows it, within
/// 0.8°.
std::optional<AnatomicalView> anatomicalViewOf(const Camera& camera);
/// Returns the side that the camera sees most of, however it is held.
AnatomicalView nearestAnatomicalView(const Camera& camera);
/// Moves the camera without turning it (orthographic: also changes its height) so that all points
/// fit, centred, with a margin of 5 % of the picture on either side where it is tightest. The
/// target moves to the middle of the points' depth. Without points, or with all in one place, the
/// distance stays. The camera must be without fault.
Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect);

/// Holds the unit vectors of the camera: right, up, and back (towards the eye).
struct CameraFrame {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 back;
};
CameraFrame cameraFrame(const Camera& camera);

/// Returns the matrix from world to camera space (x right, y up, −z forward), millimetres.
glm::mat4 viewMatrix(const Camera& camera);
/// Returns the matrix from camera space to clip space (OpenGL's −1 … 1 depth), with near and far
/// set tightly around the box so that depth keeps its precision. With the eye inside the box, near
/// is 1/4096 of far.
glm::mat4 projectionMatrix(const Camera& camera, const Box& bounds, float aspect);

/// Returns the slope of a perspective camera's line of sight at the picture's upper edge.
float edgeSlope(const Camera& camera);
/// Returns the unit vector v̂ from p towards the eye (METHOD §1; constant for an orthographic
/// camera).
glm::vec3 towardsEye(const Camera& camera, const glm::vec3& p);
/// Returns how many millimetres one pixel shows at the point's depth in a picture of that height; 0
/// for a point behind a perspective camera.
float millimetresPerPixel(const Camera& camera, const glm::vec3& p, float heightPixels);

/// Returns what is wrong with a camera, or nothing if a picture can be taken from it.
std::optional<std::string_view> cameraFault(const Camera& camera);

}  // namespace sline::model
