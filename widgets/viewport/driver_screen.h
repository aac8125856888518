// SPDX-License-Identifier: Apache-2.0
// Shows pictures as textures, by OpenGL.
#pragma once

#include <QOpenGLWidget>

#include "render/gpu/handoff.h"
#include "widgets/viewport/picture_screen.h"

namespace sline::widgets {

class DriverScreen : public QOpenGLWidget, public PictureScreen {
 public:
  DriverScreen(QWidget& parent, Told told);
  ~DriverScreen() override;

  QWidget& widget() override { return *this; }
  void setPaper(const QColor& paper) override { m_paper = paper; }
  QString driver() const override { return m_driver; }
  QOpenGLContext* shared() const override { return context(); }
  bool start() override;
  void stop() override;
  void showNewest() override { update(); }
  void blank(std::uint64_t upTo) override {
    m_blank = upTo;
    update();
  }
  QImage picture() override { return grabFramebuffer(); }

  Result<render::PictureTarget> begin(render::gpu::TextureSize size) override;
  void publish(std::uint64_t number) override { m_handoff->publish(number); }
  void releaseDrawing() override { m_handoff->releaseDrawing(); }

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void showPaper();

  Told m_told;
  QString m_driver;
  QColor m_paper;
  std::unique_ptr<render::gpu::Handoff> m_handoff;  ///< null: not started
  std::uint64_t m_shown = 0;                        ///< on screen
  std::uint64_t m_blank = 0;                        ///< pictures up to this one are not shown
};

}  // namespace sline::widgets
