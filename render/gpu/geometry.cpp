// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/geometry.h"

#include "render/gpu/gl.h"

namespace sline::render::gpu {

namespace {
GLenum componentType(AttributeType type) {
  switch (type) {
    case AttributeType::float32:
      return GL_FLOAT;
    case AttributeType::integer32:
      return GL_INT;
    case AttributeType::signed16:
      return GL_SHORT;
    case AttributeType::unsigned16:
      return GL_UNSIGNED_SHORT;
    case AttributeType::signed10x3:
      return GL_INT_2_10_10_10_REV;
  }
  return GL_FLOAT;
}
}  // namespace

Geometry::Geometry(std::vector<Stream> streams, const Buffer* indices, std::string_view name)
    : m_streams(std::move(streams)), m_indexed(indices != nullptr) {
  glGenVertexArrays(1, &m_handle);
  glBindVertexArray(m_handle);
  nameObject(vertexArrayKind, m_handle, name);
  for (const Stream& stream : m_streams) {
    for (const Attribute& attribute : stream.attributes) {
      glEnableVertexAttribArray(GLuint(attribute.location));
      glVertexAttribDivisor(GLuint(attribute.location), stream.perInstance ? 1 : 0);
    }
    point(stream, 0);
  }
  if (indices)
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->handle());
  glBindVertexArray(0);
}

Geometry::~Geometry() {
  glDeleteVertexArrays(1, &m_handle);
}

void Geometry::point(const Stream& stream, std::size_t first) const {
  glBindBuffer(GL_ARRAY_BUFFER, stream.buffer->handle());
  for (const Attribute& a : stream.attributes) {
    const std::size_t start = first * std::size_t(stream.stride) + std::size_t(a.offset);
    // OpenGL takes the byte offset as a pointer.
    const void* offset = reinterpret_cast<const void*>(start);  // NOLINT(performance-no-int-to-ptr)
    if (a.type == AttributeType::integer32)
      glVertexAttribIPointer(GLuint(a.location), a.components, GL_INT, stream.stride, offset);
    else
      glVertexAttribPointer(GLuint(a.location), a.components, componentType(a.type),
                            a.type != AttributeType::float32, stream.stride, offset);
  }
}

void Geometry::startInstancesAt(std::size_t instance) {
  glBindVertexArray(m_handle);
  for (const Stream& stream : m_streams)
    if (stream.perInstance)
      point(stream, instance);
  glBindVertexArray(0);
}

}  // namespace sline::render::gpu
