// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/target.h"

#include <cassert>
#include <string>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

Result<std::unique_ptr<Target>> Target::create(const TargetTextures& textures,
                                               std::string_view name) {
  assert(textures.colours.size() <= 4 && (textures.depth || !textures.colours.empty()));
  std::unique_ptr<Target> target(new Target);
  glGenFramebuffers(1, &target->m_handle);
  glBindFramebuffer(GL_FRAMEBUFFER, target->m_handle);
  nameObject(targetKind, target->m_handle, name);
  std::vector<GLenum> drawn;
  for (const Texture* colour : textures.colours) {
    drawn.push_back(GLenum(GL_COLOR_ATTACHMENT0 + drawn.size()));
    glFramebufferTexture2D(GL_FRAMEBUFFER, drawn.back(), GL_TEXTURE_2D, colour->handle(), 0);
    target->m_size = colour->size();
  }
  if (textures.depth) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                           textures.depth->handle(), 0);
    target->m_size = textures.depth->size();
    target->m_hasDepth = true;
  }
  const GLenum none = GL_NONE;
  glDrawBuffers(drawn.empty() ? 1 : GLsizei(drawn.size()), drawn.empty() ? &none : drawn.data());
  glReadBuffer(drawn.empty() ? GLenum(GL_NONE) : GLenum(GL_COLOR_ATTACHMENT0));
  const GLenum state = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (state != GL_FRAMEBUFFER_COMPLETE) {
    const auto* driver = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return Error{.where = std::string(name),
                 .reason = std::string("the driver ") + (driver ? driver : "(unknown)") +
                           " cannot draw into this combination of " +
                           std::to_string(target->m_size.width) + "×" +
                           std::to_string(target->m_size.height) + " textures (state " +
                           std::to_string(state) + ")",
                 .remedy = "Update the graphics driver, or use Mesa's software renderer"};
  }
  return target;
}

std::unique_ptr<Target> Target::display(TextureSize size) {
  std::unique_ptr<Target> target(new Target);
  target->m_size = size;
  return target;
}

Target::~Target() {
  if (m_handle != 0)
    glDeleteFramebuffers(1, &m_handle);
}

}  // namespace sline::render::gpu
