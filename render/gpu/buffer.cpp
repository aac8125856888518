// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/buffer.h"

#include <utility>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

namespace {
GLenum binding(BufferKind kind) {
  return kind == BufferKind::indices ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
}
}  // namespace

Buffer::Buffer(BufferKind kind, std::string_view name) : m_kind(kind) {
  glGenBuffers(1, &m_handle);
  // An index buffer binds into the current vertex array, so none may be current.
  glBindVertexArray(0);
  glBindBuffer(binding(kind), m_handle);
  nameObject(bufferKind, m_handle, name);
}

Buffer::~Buffer() {
  if (m_handle != 0)
    glDeleteBuffers(1, &m_handle);
}

Buffer::Buffer(Buffer&& other) noexcept
    : m_kind(other.m_kind),
      m_handle(std::exchange(other.m_handle, 0)),
      m_size(std::exchange(other.m_size, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(m_kind, other.m_kind);
  std::swap(m_handle, other.m_handle);
  std::swap(m_size, other.m_size);
  return *this;
}

void Buffer::replace(std::span<const std::byte> bytes, std::uint32_t usage) {
  glBindVertexArray(0);
  glBindBuffer(binding(m_kind), m_handle);
  glBufferData(binding(m_kind), GLsizeiptr(bytes.size()), bytes.data(), usage);
  m_size = bytes.size();
}

void Buffer::fill(std::span<const std::byte> bytes) {
  replace(bytes, GL_STATIC_DRAW);
}

void Buffer::stream(std::span<const std::byte> bytes) {
  replace(bytes, GL_STREAM_DRAW);
}

}  // namespace sline::render::gpu
