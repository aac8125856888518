// SPDX-License-Identifier: Apache-2.0
// Puts the renderer behind a gate, so that a test can hold it up from outside.
#pragma once

#include <QSemaphore>
#include <atomic>
#include <memory>

#include "widgets/viewport/render_thread.h"

namespace sline::test {

/// Shows and steers from outside what happens on the render thread.
struct Gate {
  QSemaphore pass;  ///< one for each picture that may begin
  std::atomic<bool> open = true;
  std::atomic<int> begun = 0;
  std::atomic<int> done = 0;
  std::atomic<std::uint64_t> last = 0;  ///< number of the last request that was begun
};

/// A painter that holds the renderer behind a gate.
class GatedPainter : public widgets::PicturePainter {
 public:
  GatedPainter(std::unique_ptr<widgets::PicturePainter> painter, std::shared_ptr<Gate> gate)
      : m_painter(std::move(painter)), m_gate(std::move(gate)) {}
  Result<bool> paint(const widgets::PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    m_gate->last = request.number;
    ++m_gate->begun;
    if (!m_gate->open)
      m_gate->pass.acquire();
    Result<bool> painted = m_painter->paint(request, job);
    ++m_gate->done;
    return painted;
  }

 private:
  std::unique_ptr<widgets::PicturePainter> m_painter;
  std::shared_ptr<Gate> m_gate;
};

/// Makes painters that stand before the renderer, of a class that takes it and what steers it.
template <class Painter, class Steered>
widgets::PainterFactory rendererBehind(const std::shared_ptr<Steered>& steered) {
  return [steered]() -> Result<std::unique_ptr<widgets::PicturePainter>> {
    auto painter = widgets::makePicturePainter();
    if (!painter)
      return painter.error();
    return std::unique_ptr<widgets::PicturePainter>(
        std::make_unique<Painter>(std::move(*painter), steered));
  };
}

inline widgets::PainterFactory gated(const std::shared_ptr<Gate>& gate) {
  return rendererBehind<GatedPainter>(gate);
}

}  // namespace sline::test
