// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/gpu/device.h"

namespace sline::render {

/// Bounds what the driver has under way. A software driver sets triangles up faster than it fills
/// them, and keeps all that wait in memory (300 MiB for 3 million triangles); and anything that
/// another context draws meanwhile, such as the window itself, has to wait its turn behind it.
class DrawQueue {
 public:
  /// The largest size of a single draw, which cannot be interrupted.
  static constexpr std::size_t mostIndices = 99'999;
  static constexpr std::size_t mostStrokes = 4'000;

  void addTriangles(gpu::Device& device, std::size_t indices) { add(device, indices); }
  void addStrokes(gpu::Device& device, std::size_t count) { add(device, 24 * count); }
  void addCopies(gpu::Device& device, const PixelRect& area) {
    add(device, std::size_t(area.width) * std::size_t(area.height) / 10);
  }

 private:
  /// Weights measure what keeps llvmpipe equally long: `longest` is about 10 ms on two cores.
  static constexpr std::size_t longest = 100'000;

  void add(gpu::Device& device, std::size_t work) {
    m_waiting += work;
    if (m_waiting < longest)
      return;
    device.finish();
    m_waiting = 0;
  }

  std::size_t m_waiting = 0;
};

}  // namespace sline::render
