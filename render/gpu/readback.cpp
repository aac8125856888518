// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/readback.h"

#include <bit>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

Result<const Target*> Readback::begin(TextureSize size) {
  if (!m_target || m_target->size() != size) {
    release();
    m_texture = std::make_unique<Texture>(TextureFormat::rgba8, size, "picture to read");
    auto target = Target::create({{m_texture.get()}, nullptr}, "picture to read");
    if (!target)
      return target.error();
    m_target = std::move(*target);
  }
  return static_cast<const Target*>(m_target.get());
}

Status Readback::read(std::span<std::uint32_t> pixels) {
  const auto [width, height] = m_target ? m_target->size() : TextureSize{};
  const auto columns = std::size_t(width);
  if (!m_target || pixels.size() != columns * std::size_t(height))
    return misfit(pixels.size_bytes(), {0, 0, width, height});
  m_rows.resize(pixels.size());
  glBindFramebuffer(GL_FRAMEBUFFER, m_target->handle());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, m_rows.data());
  static_assert(std::endian::native == std::endian::little, "red is the lowest byte");
  for (std::size_t row = 0; row < std::size_t(height); ++row) {
    const std::uint32_t* from = m_rows.data() + (std::size_t(height) - 1 - row) * columns;
    std::uint32_t* to = pixels.data() + row * columns;
    for (std::size_t x = 0; x < columns; ++x)
      to[x] = 0xff000000u | (from[x] & 0xffu) << 16 | (from[x] & 0xff00u) | (from[x] >> 16 & 0xffu);
  }
  return Unit{};
}

void Readback::release() {
  m_target.reset();
  m_texture.reset();
}

}  // namespace sline::render::gpu
