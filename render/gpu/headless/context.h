// SPDX-License-Identifier: Apache-2.0
// Makes an OpenGL context without a display: on EGL's surfaceless platform, or on a device where
// that is absent.
#pragma once

#include <memory>
#include <string>

#include "model/base/result.h"

namespace sline::render::gpu {

class HeadlessContext {
 public:
  /// Tells whether the machine may have a graphics card, without opening anything: Linux has a file
  /// for each (/dev/dri, /dev/nvidia…, /dev/dxg).
  static bool mayBeOnCard();
  /// Makes the context and makes it current on the calling thread. The error says what was tried
  /// and what to install.
  static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Returns "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL surfaceless".
  const std::string& driver() const;
  void makeCurrent();

 private:
  HeadlessContext();
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render::gpu
