// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/texture.h"

#include <string>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

namespace {
struct Layout {
  GLenum internal;
  GLenum format;
  GLenum type;
};

Layout layout(TextureFormat format) {
  switch (format) {
    case TextureFormat::rgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TextureFormat::rgba16:
      return {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
    case TextureFormat::rg8:
      return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
    case TextureFormat::r32i:
      return {GL_R32I, GL_RED_INTEGER, GL_INT};
    case TextureFormat::rgba32i:
      return {GL_RGBA32I, GL_RGBA_INTEGER, GL_INT};
    case TextureFormat::rgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case TextureFormat::depth32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {};
}
}  // namespace

Error misfit(std::size_t bytes, const PixelRect& area) {
  return {.reason = "the program held " + std::to_string(bytes) + " bytes for " +
                    std::to_string(area.width) + "×" + std::to_string(area.height) +
                    " pixels of the picture, which is not what they take",
          .remedy = "Save the scene and start the program again"};
}

int pixelSize(TextureFormat format) {
  switch (format) {
    case TextureFormat::rgba8:
    case TextureFormat::r32i:
    case TextureFormat::depth32f:
      return 4;
    case TextureFormat::rgba16:
      return 8;
    case TextureFormat::rg8:
      return 2;
    case TextureFormat::rgba32i:
    case TextureFormat::rgba32f:
      return 16;
  }
  return 0;
}

Texture::Texture(TextureFormat format, TextureSize size, std::string_view name)
    : m_format(format), m_size(size) {
  glGenTextures(1, &m_handle);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, m_handle);
  nameObject(textureKind, m_handle, name);
  const Layout l = layout(format);
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(l.internal), size.width, size.height, 0, l.format, l.type,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

Texture::~Texture() {
  glDeleteTextures(1, &m_handle);
}

Status Texture::upload(std::span<const std::byte> bytes, int rows) {
  return upload(bytes, {0, 0, m_size.width, rows});
}

Status Texture::upload(std::span<const std::byte> bytes, const PixelRect& area) const {
  if (area.empty() && bytes.empty())
    return Unit{};
  const PixelRect all{0, 0, m_size.width, m_size.height};
  // The driver reads as much as the area takes, whatever there is.
  if (area.empty() || intersection(area, all) != area ||
      bytes.size() != std::size_t(area.width) * area.height * pixelSize(m_format))
    return misfit(bytes.size(), area);
  const Layout l = layout(m_format);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, m_handle);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, area.x, area.y, area.width, area.height, l.format, l.type,
                  bytes.data());
  return Unit{};
}

}  // namespace sline::render::gpu
