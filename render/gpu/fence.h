// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::render::gpu {

/// Marks a place in the work that was requested of the driver, which starts on it at once.
class Fence {
 public:
  Fence();
  ~Fence();
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  /// Waits until all that was requested before the fence is done; in a browser, which lets nothing
  /// wait, it only asks for it.
  void wait();

 private:
  void* m_sync = nullptr;
};

}  // namespace sline::render::gpu
