// SPDX-License-Identifier: Apache-2.0
// Holds pixels of a driver's that pictures are drawn into, as windows do.
#pragma once

#include <memory>
#include <vector>

#include "render/gpu/device.h"
#include "render/picture/picture.h"

namespace sline::test {

class TargetPixels {
 public:
  /// Makes room for pictures of these settings; needs a current context.
  explicit TargetPixels(const render::PictureSettings& settings)
      : m_size{.width = settings.width, .height = settings.height},
        m_pixels(render::gpu::TextureFormat::rgba8, m_size, "pixels"),
        m_target(render::gpu::Target::create({{&m_pixels}, nullptr}, "pixels")),
        m_device(render::gpu::Device::create()) {}

  bool ok() const { return m_target.ok() && m_device.ok(); }
  const render::gpu::Target& target() const { return **m_target; }
  void clear() { (*m_device)->clear(target(), {.colour = glm::vec4(0.5f)}); }
  /// Returns what is there.
  render::Image image() {
    const std::size_t row = std::size_t(m_size.width) * 4;
    std::vector<std::byte> rows(row * std::size_t(m_size.height));
    if (!(*m_device)->read(target(), {0, 0, m_size.width, m_size.height}, rows))
      return {};
    render::Image image{.width = m_size.width, .height = m_size.height, .rgba = {}};
    image.rgba.reserve(rows.size());
    for (std::size_t y = std::size_t(m_size.height); y-- > 0;)
      for (std::size_t x = 0; x < row; ++x)
        image.rgba.push_back(std::uint8_t(rows[y * row + x]));
    return image;
  }

 private:
  render::gpu::TextureSize m_size;
  render::gpu::Texture m_pixels;
  Result<std::unique_ptr<render::gpu::Target>> m_target;
  Result<std::unique_ptr<render::gpu::Device>> m_device;
};

}  // namespace sline::test
