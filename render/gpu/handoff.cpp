// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/handoff.h"

#include <cassert>
#include <string>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

namespace {

/// Long enough for any driver to finish a copy; a context that was lost never does.
constexpr std::uint64_t patience = 1'000'000'000;  // nanoseconds

void forget(void*& fence) {
  if (fence)
    glDeleteSync(static_cast<GLsync>(fence));
  fence = nullptr;
}

}  // namespace

Handoff::~Handoff() {
  assert(m_reader == 0);
}

Result<const Target*> Handoff::begin(TextureSize size) {
  void* shown = nullptr;
  {
    const std::lock_guard lock(m_mutex);
    m_drawing = 0;
    while (m_drawing == m_newest || m_drawing == m_showing)
      ++m_drawing;
    std::swap(shown, m_turns[std::size_t(m_drawing)].shown);
  }
  if (shown)
    glClientWaitSync(static_cast<GLsync>(shown), 0, patience);
  forget(shown);
  Turn& turn = m_turns[std::size_t(m_drawing)];
  if (!turn.target || turn.target->size() != size) {
    turn.target.reset();
    turn.texture.reset();
    turn.texture = std::make_unique<Texture>(TextureFormat::rgba8, size, "shown picture");
    turn.target = TRY(Target::create({{turn.texture.get()}, nullptr}, "shown picture"));
  }
  return static_cast<const Target*>(turn.target.get());
}

void Handoff::publish(std::uint64_t number) {
  glFinish();
  const std::lock_guard lock(m_mutex);
  if (m_drawing == none)
    return;
  m_turns[std::size_t(m_drawing)].number = number;
  m_newest = m_drawing;
  m_drawing = none;
}

void Handoff::releaseDrawing() {
  for (Turn& turn : m_turns) {
    forget(turn.shown);
    turn = {};
  }
  m_drawing = m_newest = m_showing = none;
}

void Handoff::blit(const Texture& picture, TextureSize viewport) {
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  if (m_reader == 0)
    glGenFramebuffers(1, &m_reader);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, m_reader);
  // Attached anew each time: this makes the other context's changes visible in this one.
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.handle(),
                         0);
  glDisable(GL_SCISSOR_TEST);
  const TextureSize size = picture.size();
  glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, viewport.width, viewport.height,
                    GL_COLOR_BUFFER_BIT, size == viewport ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(drawn));
}

void Handoff::warmUp() {
  const Texture some(TextureFormat::rgba8, {3, 5}, "warm-up");  // no powers of two, as in pictures
  blit(some, {7, 11});
}

std::uint64_t Handoff::show(TextureSize viewport) {
  const std::lock_guard lock(m_mutex);
  if (m_newest != none) {
    m_showing = m_newest;
    m_newest = none;
  }
  if (m_showing == none)
    return 0;
  Turn& turn = m_turns[std::size_t(m_showing)];
  blit(*turn.texture, viewport);
  forget(turn.shown);
  turn.shown = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
  return turn.number;
}

void Handoff::releaseShowing() {
  const std::lock_guard lock(m_mutex);
  if (m_reader != 0)
    glDeleteFramebuffers(1, &m_reader);
  m_reader = 0;
  if (m_showing != none)
    forget(m_turns[std::size_t(m_showing)].shown);
  m_showing = none;
}

}  // namespace sline::render::gpu
