// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "model/base/result.h"
#include "render/gpu/texture.h"
#include "render/raster/pixel_rect.h"

namespace sline::render::gpu {

/// Holds what a pass draws into: up to four colour textures and a depth texture of one size, which
/// must outlive the target.
struct TargetTextures {
  std::vector<const Texture*> colours;
  const Texture* depth = nullptr;
};

class Target {
 public:
  /// Creates the target. The error says which driver refused which combination of formats.
  static Result<std::unique_ptr<Target>> create(const TargetTextures& textures,
                                                std::string_view name);
  /// Returns the context's own framebuffer of that size, as a browser's canvas has it.
  static std::unique_ptr<Target> display(TextureSize size);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  TextureSize size() const { return m_size; }
  bool hasDepth() const { return m_hasDepth; }
  std::uint32_t handle() const { return m_handle; }

 private:
  Target() = default;
  std::uint32_t m_handle = 0;
  TextureSize m_size;
  bool m_hasDepth = false;
};

}  // namespace sline::render::gpu
