// SPDX-License-Identifier: Apache-2.0
// Tools: what a pressed mouse does in the picture, as small objects that need no window.
#pragma once

#include <Qt>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "model/scene/camera.h"

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
  model::Camera camera;            ///< it was drawn with: it may lag behind the one that moves
  glm::vec2 size{1.0f};            ///< pixels
  std::optional<glm::vec2> mouse;  ///< over it, while no tool is held
};

/// The view that tools look through and move.
class ViewControl {
 public:
  virtual ~ViewControl() = default;
  virtual const model::Camera& camera() const = 0;
  virtual glm::vec3 pivot() const = 0;
  virtual void move(const model::Camera& camera) = 0;
};

class Tool {
 public:
  virtual ~Tool() = default;
  /// True where the tool takes the mouse: it then hears of every move until release or cancel.
  virtual bool press(const Pointer& pointer) = 0;
  virtual void move(const Pointer& pointer) = 0;
  virtual void release(const Pointer& pointer) = 0;
  /// All is as it was before the press.
  virtual void cancel() = 0;

  /// True where a press would take hold of a thing that is seen there.
  virtual bool grips(const Pointer&) const { return false; }
  /// The cursor over such a thing.
  virtual std::optional<Qt::CursorShape> cursor(const Pointer&) const { return std::nullopt; }
  /// It hears of moves from the first pixel on, not only once a hand that shakes in a click cannot
  /// have made them.
  virtual bool movesAtOnce() const { return false; }
  /// The release of what it took is never a click.
  virtual bool keepsClicks() const { return false; }
  /// Shows what it has over the picture, which is another one or lies under another mouse now.
  virtual void show(const ShownPicture&) {}
  /// The picture's background is dark, or no more.
  virtual void setDark(bool) {}
};

}  // namespace sline::widgets
