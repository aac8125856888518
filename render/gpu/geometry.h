// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "render/gpu/buffer.h"

namespace sline::render::gpu {

/// Tells how a vertex attribute lies in its buffer; integers arrive in the shader as −1 … 1 or 0 …
/// 1, but `integer32` as integers.
enum class AttributeType {
  float32,
  integer32,
  signed16,
  unsigned16,
  signed10x3,  ///< three signed 10-bit numbers and one of 2 bits in 32 bits
};

struct Attribute {
  int location = 0;
  int components = 4;
  AttributeType type = AttributeType::float32;
  int offset = 0;  ///< bytes from the start of a vertex
};

/// A buffer of vertices or, with `perInstance`, of instances; it must outlive the geometry.
struct Stream {
  const Buffer* buffer = nullptr;
  int stride = 0;  ///< bytes from one vertex to the next
  std::vector<Attribute> attributes;
  bool perInstance = false;
};

/// Holds what a draw call reads: streams, and 32-bit indices where there are any.
class Geometry {
 public:
  Geometry(std::vector<Stream> streams, const Buffer* indices, std::string_view name);
  ~Geometry();
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  /// Sets the first instance of the next draw (ES 3.0 has no draw call that takes it).
  void startInstancesAt(std::size_t instance);
  bool indexed() const { return m_indexed; }
  std::uint32_t handle() const { return m_handle; }

 private:
  void point(const Stream& stream, std::size_t first) const;

  std::vector<Stream> m_streams;
  std::uint32_t m_handle = 0;
  bool m_indexed = false;
};

}  // namespace sline::render::gpu
