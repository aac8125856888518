// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace sline::render::gpu {

enum class BufferKind { vertices, indices };

/// A buffer is memory of the driver. It needs its context current when it is made, filled and
/// destroyed.
class Buffer {
 public:
  Buffer(BufferKind kind, std::string_view name);
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Sets contents that stay; they are copied, so the caller's may be freed.
  void fill(std::span<const std::byte> bytes);
  /// Sets contents that change every frame; draws under way keep the old ones.
  void stream(std::span<const std::byte> bytes);

  std::size_t size() const { return m_size; }
  std::uint32_t handle() const { return m_handle; }

 private:
  void replace(std::span<const std::byte> bytes, std::uint32_t usage);

  BufferKind m_kind;
  std::uint32_t m_handle = 0;
  std::size_t m_size = 0;
};

}  // namespace sline::render::gpu
