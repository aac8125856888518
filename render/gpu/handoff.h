// SPDX-License-Identifier: Apache-2.0
// Passes finished pictures from the context that draws them to the one that shows them. The two
// contexts share textures and run on threads of their own. Three pictures take turns: one can be
// shown, the newest lie ready and a third be drawn, so that the showing side never waits.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>

#include "render/gpu/target.h"

namespace sline::render::gpu {

class Handoff {
 public:
  Handoff() = default;
  ~Handoff();
  Handoff(const Handoff&) = delete;
  Handoff& operator=(const Handoff&) = delete;

  /// Drawing side: returns a target of that size that is not being shown. It waits (here, not on
  /// the showing side) until the showing side's last use of it is done.
  Result<const Target*> begin(TextureSize size);
  /// Drawing side: declares the target from `begin` drawn. It waits for the GPU, so that the
  /// showing side need not. The picture becomes the newest; a newest picture that was never shown
  /// is drawn over next. Without `begin` there is nothing to declare.
  void publish(std::uint64_t number);
  /// Drawing side, its context current: releases everything. The showing side must be done.
  void releaseDrawing();

  /// Showing side: scales a picture of a few pixels into a corner of the framebuffer that is bound
  /// for drawing. Drivers make their programs at first use, which takes too long in the middle of a
  /// drag, so this must be called once, before anything is shown.
  void warmUp();
  /// Showing side: fills the viewport of the framebuffer that is bound for drawing with the newest
  /// picture, scaled where sizes differ. Returns that picture's number; 0 where there is none yet.
  std::uint64_t show(TextureSize viewport);
  /// Showing side, its context current: releases what belongs to it alone.
  void releaseShowing();

 private:
  void blit(const Texture& picture, TextureSize viewport);

  /// Holds a picture and its last use by the showing side.
  struct Turn {
    std::unique_ptr<Texture> texture;
    std::unique_ptr<Target> target;
    std::uint64_t number = 0;
    void* shown = nullptr;  ///< a fence; null: never shown since it was drawn
  };
  static constexpr int none = -1;

  std::mutex m_mutex;  ///< guards indices and fences; the drawing side never holds it for long
  std::array<Turn, 3> m_turns;
  int m_drawing = none;
  int m_newest = none;
  int m_showing = none;
  std::uint32_t m_reader = 0;  ///< the showing side's framebuffer
};

}  // namespace sline::render::gpu
