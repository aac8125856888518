// SPDX-License-Identifier: Apache-2.0
// The thread that draws pictures, in an OpenGL context of its own. The newest request wins; one
// that is overtaken before it begins is never drawn.
#pragma once

#include <QOffscreenSurface>
#include <QThread>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "model/base/result.h"
#include "render/gpu/handoff.h"
#include "render/picture/picture.h"

class QOpenGLContext;

namespace sline::widgets {

struct PictureRequest {
  std::uint64_t number = 0;  ///< from 1 upwards
  model::Scene scene;
  model::Camera camera;
  render::PictureSettings settings;
  float scale = 1.0f;   ///< of the picture's size to the window's; what is shown is as large
  bool moving = false;  ///< camera or section are on their way; else they rest, and their picture
                        ///< is given up when they move on
};

/// Draws requests; lives on the render thread, whose context is current.
class PicturePainter {
 public:
  virtual ~PicturePainter() = default;
  /// False where the picture was given up because nobody wants it any more.
  virtual Result<bool> paint(const PictureRequest& request,
                             const render::Picture::TargetJob& job) = 0;
};
using PainterFactory = std::function<Result<std::unique_ptr<PicturePainter>>()>;
/// The renderer itself.
Result<std::unique_ptr<PicturePainter>> makePicturePainter();

/// A picture that is done and waits in the handoff.
struct PictureReport {
  std::uint64_t number = 0;
  double milliseconds = 0.0;
  float scale = 1.0f;   ///< as requested
  bool moving = false;  ///< as requested
  model::Camera camera;
};

class RenderThread : public QThread {
  Q_OBJECT
 public:
  /// Starts at once. The handoff must outlive the thread. To be called on the GUI's thread.
  RenderThread(QOpenGLContext& shareWith, render::gpu::Handoff& handoff, PainterFactory factory);
  /// Waits until the picture under way is done or given up.
  ~RenderThread() override;

  void ask(PictureRequest request);

 signals:
  void drawn(const sline::widgets::PictureReport& report);
  void failed(const sline::Error& error);

 protected:
  void run() override;

 private:
  std::optional<PictureRequest> next();
  Result<bool> draw(PicturePainter& painter, const PictureRequest& request);

  render::gpu::Handoff& m_handoff;
  PainterFactory m_factory;
  QOffscreenSurface m_surface;
  std::unique_ptr<QOpenGLContext> m_context;
  std::mutex m_mutex;
  std::condition_variable m_wake;
  std::optional<PictureRequest> m_request;
  bool m_quit = false;
  /// Of the picture under way: its camera, where it rests.
  std::optional<model::Camera> m_resting;
  std::atomic<bool> m_unwanted = false;
};

}  // namespace sline::widgets
