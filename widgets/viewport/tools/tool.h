// SPDX-License-Identifier: Apache-2.0
// Defines tools: what a pressed mouse does in the picture, as small objects that need no window.
#pragma once

#include <Qt>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "model/camera/camera_moves.h"

namespace sline::widgets {

/// The mouse in the picture; pixels count from the upper left corner, y downwards.
struct Pointer {
  glm::vec2 pixel{0.0f};
  glm::vec2 size{1.0f};  ///< of the picture
  Qt::MouseButton button = Qt::NoButton;
  Qt::KeyboardModifiers keys;
};

/// The picture on screen.
struct ShownPicture {
  model::Camera camera;            ///< of the picture: it may lag behind the moving camera
  glm::vec2 size{1.0f};            ///< pixels
  std::optional<glm::vec2> mouse;  ///< over the picture, while no tool is held
};

/// The view that tools look through and move.
class ViewControl {
 public:
  virtual ~ViewControl() = default;
  virtual const model::Camera& camera() const = 0;
  virtual glm::vec3 pivot() const = 0;
  virtual void move(const model::Camera& camera) = 0;
  /// Returns how far tools may zoom.
  virtual model::ZoomEnds zoomEnds() const { return {}; }
};

class Tool {
 public:
  virtual ~Tool() = default;
  /// Returns true if the tool takes the mouse: it then gets every move until release or cancel.
  virtual bool press(const Pointer& pointer) = 0;
  virtual void move(const Pointer& pointer) = 0;
  /// Notes where the mouse passes while the tool has it; moves come only once for each picture.
  virtual void passes(const Pointer&) {}
  virtual void release(const Pointer& pointer) = 0;
  /// Restores everything as it was before the press.
  virtual void cancel() = 0;

  /// Tells whether a press would take hold of a thing that is seen there.
  virtual bool grips(const Pointer&) const { return false; }
  /// Returns the cursor over such a thing.
  virtual std::optional<Qt::CursorShape> cursor(const Pointer&) const { return std::nullopt; }
  /// Tells whether the tool gets moves from the first pixel on, instead of only once they are too
  /// large for the tremor of a hand that clicks.
  virtual bool movesAtOnce() const { return false; }
  /// Tells whether the release after a press that it took is never a click.
  virtual bool keepsClicks() const { return false; }
  /// Updates what it shows over the picture, after the picture or the mouse over it has changed.
  virtual void show(const ShownPicture&) {}
  /// Tells the tool whether the picture's background is dark.
  virtual void setDark(bool) {}
};

}  // namespace sline::widgets
