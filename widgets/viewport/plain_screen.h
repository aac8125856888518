// SPDX-License-Identifier: Apache-2.0
// Shows pictures as pixels, without OpenGL.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "widgets/viewport/picture_screen.h"

namespace sline::widgets {

class PlainScreen : public QWidget, public PictureScreen {
 public:
  PlainScreen(QWidget& parent, Told told, QString driver);

  QWidget& widget() override { return *this; }
  void setPaper(const QColor& paper) override;
  QString driver() const override { return m_driver; }
  QOpenGLContext* shared() const override { return nullptr; }
  bool start() override { return true; }
  void stop() override;
  void showNewest() override;
  void blank(std::uint64_t upTo) override;
  QImage picture() override;

  Result<render::PictureTarget> begin(render::gpu::TextureSize size) override;
  void publish(std::uint64_t number) override;
  void releaseDrawing() override { m_rows = {}; }

 protected:
  void showEvent(QShowEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Numbered {
    QImage image;
    std::uint64_t number = 0;  ///< 0: none
    std::uint64_t turn = 0;    ///< counts what was published
  };
  void takeNewest();
  bool isBlank() const { return m_showing.number <= m_blank; }

  Told m_told;
  QString m_driver;
  QColor m_paper;
  bool m_opened = false;
  Numbered m_showing;
  std::uint64_t m_shown = 0;  ///< what was last told
  std::uint64_t m_blank = 0;  ///< pictures up to this one are not shown
  // Three pictures take turns, so that neither side waits: one is shown, one lies ready and one is
  // drawn.
  std::mutex m_mutex;
  Numbered m_newest;  ///< guarded by it
  // The drawing side's own.
  std::vector<std::uint32_t> m_rows;  ///< as `PictureTarget` has them
  render::gpu::TextureSize m_size;
  std::uint64_t m_turn = 0;
  Numbered m_drawn;
};

}  // namespace sline::widgets
