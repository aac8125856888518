// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/gpu/device.h"

namespace sline::render {

/// Bounds what the driver has to remember: a software driver sets triangles up faster than it fills
/// them, and keeps all that wait in memory (300 MiB for 3 million triangles).
class DrawQueue {
 public:
  void add(gpu::Device& device, std::uint32_t indices) {
    m_waiting += indices;
    if (m_waiting < longest)
      return;
    device.finish();
    m_waiting = 0;
  }

 private:
  static constexpr std::uint32_t longest = 100'000;
  std::uint32_t m_waiting = 0;
};

}  // namespace sline::render
