// SPDX-License-Identifier: Apache-2.0
// What pictures appear on: the lowest widget in the viewport. Where there is a graphics card that
// is a widget of OpenGL's. With one in it, a window is put together by the driver, texture by
// texture, whenever anything in it changes; where the driver draws on the processor that took a
// fifth of the time of a moving picture, so there it is a plain widget.
#pragma once

#include <QColor>
#include <QImage>
#include <QSurfaceFormat>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <memory>

#include "render/gpu/target.h"
#include "render/picture/picture.h"

class QOpenGLContext;

namespace sline::widgets {

/// Belongs to two sides: one shows, on the GUI's thread, and one draws, on a thread of its own.
class PictureScreen {
 public:
  /// What a screen tells its showing side.
  struct Told {
    std::function<void()> ready;    ///< pictures may be drawn from now on
    std::function<void()> closing;  ///< they may not any more; `stop` has to follow at once
    std::function<void(std::uint64_t)> shown;  ///< that picture is on screen
  };

  virtual ~PictureScreen() = default;

  virtual QWidget& widget() = 0;
  /// Sets the colour that is shown until there is a picture.
  virtual void setPaper(const QColor& paper) = 0;
  /// Returns OpenGL's own name for itself, where it is known.
  virtual QString driver() const = 0;
  /// Returns the context whose textures the drawing side shares; null where it draws into memory,
  /// without OpenGL.
  virtual QOpenGLContext* shared() const = 0;
  /// Called after `ready`, before anything is drawn; returns false where it is not ready any more.
  virtual bool start() = 0;
  /// Forgets all pictures; the drawing side must be done.
  virtual void stop() = 0;
  /// Brings the newest picture on screen, soon.
  virtual void showNewest() = 0;
  /// Shows paper at once, and no picture up to that number: what they show is open no longer.
  virtual void blank(std::uint64_t upTo) = 0;
  /// Returns the newest picture as it is on screen, in the screen's own pixels.
  virtual QImage picture() = 0;

  /// Drawing side: returns a target of that size; declares it drawn, after which the next
  /// `showNewest` shows it; and releases everything, the context, if any, being current.
  virtual Result<render::PictureTarget> begin(render::gpu::TextureSize size) = 0;
  /// The same number may come again, with a better picture.
  virtual void publish(std::uint64_t number) = 0;
  virtual void releaseDrawing() = 0;
};

/// Returns the screen's size in its own pixels.
render::gpu::TextureSize pixelsOf(const QWidget& screen);

/// The OpenGL that pictures need.
QSurfaceFormat pictureFormat();

/// Says what pictures appear on; `automatic`: as the driver draws.
enum class ScreenKind { automatic, driver, plain };

/// Sets what viewports have that are made from now on; for tests.
void chooseScreens(ScreenKind kind);

/// Returns a screen within that widget.
std::unique_ptr<PictureScreen> makePictureScreen(QWidget& parent, PictureScreen::Told told);

}  // namespace sline::widgets
