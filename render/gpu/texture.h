// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "model/base/result.h"
#include "render/raster/pixel_rect.h"

namespace sline::render::gpu {

/// Lists the formats of textures. `rgba16` exists in OpenGL only: ES 3.0 does not guarantee it.
enum class TextureFormat { rgba8, rgba16, rg8, r32i, rgba32i, rgba32f, depth32f };

struct TextureSize {
  int width = 0;
  int height = 0;
  bool operator==(const TextureSize&) const = default;
};

/// A texture has one level of pixels, read by texel (no filtering), clamped at its border. Its
/// contents are undefined until cleared, drawn or uploaded.
class Texture {
 public:
  Texture(TextureFormat format, TextureSize size, std::string_view name);
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  /// Replaces the first `rows` rows; bytes are tightly packed.
  Status upload(std::span<const std::byte> bytes, int rows);
  /// Replaces the pixels of the area, whose rows follow each other from the bottom. Where the area
  /// does not lie within the texture, or the bytes are not as many as it takes, nothing is read or
  /// written, and the error says so.
  Status upload(std::span<const std::byte> bytes, const PixelRect& area) const;

  TextureSize size() const { return m_size; }
  TextureFormat format() const { return m_format; }
  std::uint32_t handle() const { return m_handle; }

 private:
  TextureFormat m_format;
  TextureSize m_size;
  std::uint32_t m_handle = 0;
};

/// Says that so many bytes are not what an area's pixels take, as only a fault of the program's own
/// brings about.
Error misfit(std::size_t bytes, const PixelRect& area);

/// Returns the bytes of one pixel.
int pixelSize(TextureFormat format);

}  // namespace sline::render::gpu
