// SPDX-License-Identifier: Apache-2.0
// Reads pictures back for windows that put pixels on screen themselves. All on the drawing side,
// its context current.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/gpu/target.h"

namespace sline::render::gpu {

class Readback {
 public:
  /// Returns a target of that size.
  Result<const Target*> begin(TextureSize size);
  /// Fills `pixels` with the target's, 0xffRRGGBB each, rows from the top. Where these are not as
  /// many nothing is read, and the error says so.
  Status read(std::span<std::uint32_t> pixels);
  /// Releases everything.
  void release();

 private:
  std::unique_ptr<Texture> m_texture;
  std::unique_ptr<Target> m_target;
  std::vector<std::uint32_t> m_rows;  ///< as OpenGL has them
};

}  // namespace sline::render::gpu
