// SPDX-License-Identifier: Apache-2.0
// Knows where OpenGL's functions come from, as the only such place: libepoxy on the desktop, the
// browser's OpenGL ES 3.0 on the web. It is private to render/gpu.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
// OpenGL ES has no such textures, and nobody asks for them there (PictureOptions::deep).
#define GL_RGBA16 GL_RGBA8
#else
#include <epoxy/gl.h>
#endif

#include <string_view>

namespace sline::render::gpu {

/// Gives the object a name for debuggers and driver messages; does nothing where KHR_debug is
/// absent.
inline void nameObject([[maybe_unused]] GLenum kind, [[maybe_unused]] GLuint handle,
                       [[maybe_unused]] std::string_view name) {
#ifndef __EMSCRIPTEN__
  if (!name.empty() && epoxy_has_gl_extension("GL_KHR_debug"))
    glObjectLabel(kind, handle, GLsizei(name.size()), name.data());
#endif
}

#ifdef __EMSCRIPTEN__
inline constexpr GLenum bufferKind = 0;
inline constexpr GLenum vertexArrayKind = 0;
inline constexpr GLenum programKind = 0;
inline constexpr GLenum textureKind = 0;
inline constexpr GLenum targetKind = 0;
#else
inline constexpr GLenum bufferKind = GL_BUFFER;
inline constexpr GLenum vertexArrayKind = GL_VERTEX_ARRAY;
inline constexpr GLenum programKind = GL_PROGRAM;
inline constexpr GLenum textureKind = GL_TEXTURE;
inline constexpr GLenum targetKind = GL_FRAMEBUFFER;
#endif

}  // namespace sline::render::gpu
