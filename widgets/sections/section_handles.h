// SPDX-License-Identifier: Apache-2.0
// Computes the parts by which a section plane is dragged: its outline, an arrow to move and flip
// it, two rings to tilt it. Geometry without a window; pixels count from the picture's upper left
// corner.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/mesh.h"
#include "model/geometry/plane.h"

namespace sline::widgets {

/// The rectangle of a plane that encloses everything it cuts.
struct SectionFrame {
  model::Plane plane;
  glm::vec3 centre{0.0f};
  glm::vec3 u{1.0f, 0.0f, 0.0f};  ///< unit; as in model::axesOf
  glm::vec3 v{0.0f, 0.0f, 1.0f};
  float halfU = 0.0f;
  float halfV = 0.0f;
  /// The limits of the plane: offsets at which it still touches the bounds.
  float lowest = 0.0f;
  float highest = 0.0f;
};
SectionFrame sectionFrame(const model::Plane& plane, const model::Box& bounds);

/// The kinds of drag. slide: along the normal; flip: to the other side; the others turn about an
/// axis of the frame.
enum class SectionGrip { none, slide, flip, turnAboutU, turnAboutV };

/// The frame as it is seen.
struct SectionHandles {
  std::vector<glm::vec2> outline;  ///< the part of the rectangle in front of the eye, closed
  glm::vec2 slide{0.0f};           ///< the arrow's foot
  glm::vec2 tip{0.0f};             ///< its head, towards the side that is removed
  bool endOn = false;              ///< seen almost along the arrow: drawn as a ring with a dot
  std::optional<glm::vec2> turnAboutU;
  std::optional<glm::vec2> turnAboutV;
};
/// Returns the handles; absent where no part of the plane is in the picture.
std::optional<SectionHandles> sectionHandles(const SectionFrame& frame, const model::Camera& camera,
                                             const glm::vec2& size);
/// Returns the part that a press at the pixel takes hold of.
SectionGrip gripAt(const SectionHandles& handles, const glm::vec2& pixel);

/// A drag of a section, from the press to the release.
class SectionDrag {
 public:
  struct Start {
    SectionGrip grip = SectionGrip::slide;
    glm::vec2 pixel{0.0f};
    SectionFrame frame;
    model::Camera camera;
    glm::vec2 size{1.0f};
  };
  explicit SectionDrag(const Start& start) : m_start(start) {}
  /// Returns the plane for the mouse at that pixel, which depends on where the drag began, not on
  /// the path. `snap`: to whole steps, either a round length that suits what is cut, or 15°.
  model::Plane at(const glm::vec2& pixel, bool snap) const;
  /// Returns the angle of a turn, in degrees.
  double turnAt(const glm::vec2& pixel, bool snap) const;

 private:
  double slideAt(const glm::vec2& pixel) const;

  Start m_start;
};

}  // namespace sline::widgets
