// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/fence.h"

#include "render/gpu/gl.h"

namespace sline::render::gpu {

Fence::Fence() : m_sync(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {
  glFlush();
}

Fence::~Fence() {
  glDeleteSync(GLsync(m_sync));
}

void Fence::wait() {
#ifdef __EMSCRIPTEN__
  glClientWaitSync(GLsync(m_sync), GL_SYNC_FLUSH_COMMANDS_BIT, 0);
#else
  constexpr GLuint64 nanoseconds = 1'000'000'000;
  while (glClientWaitSync(GLsync(m_sync), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds) ==
         GL_TIMEOUT_EXPIRED) {
  }
#endif
}

}  // namespace sline::render::gpu
