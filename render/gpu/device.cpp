// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/device.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

#include "render/gpu/gl.h"
#ifdef __EMSCRIPTEN__
#include <emscripten/html5_webgl.h>
#endif

namespace sline::render::gpu {

namespace {

std::string text(GLenum name) {
  const auto* s = reinterpret_cast<const char*>(glGetString(name));
  return s ? s : "";
}

/// Returns who draws. Browsers tell it apart from what they call themselves.
std::string rendererName() {
#ifdef __EMSCRIPTEN__
  constexpr GLenum unmaskedRenderer = 0x9246;
  if (emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(),
                                        "WEBGL_debug_renderer_info"))
    return text(unmaskedRenderer);
#endif
  return text(GL_RENDERER);
}

/// Mesa's, Chromium's and Windows' drivers for machines without a graphics card.
bool isSoftware(std::string_view renderer) {
  constexpr std::array<std::string_view, 6> names{
      "llvmpipe", "softpipe", "swrast", "SwiftShader", "Microsoft Basic Render", "GDI Generic"};
  return std::any_of(names.begin(), names.end(), [renderer](std::string_view name) {
    return renderer.find(name) != std::string_view::npos;
  });
}

void enable(GLenum what, bool on) {
  if (on)
    glEnable(what);
  else
    glDisable(what);
}

GLenum depthFunction(DepthTest test) {
  switch (test) {
    case DepthTest::less:
      return GL_LESS;
    case DepthTest::lessEqual:
      return GL_LEQUAL;
    case DepthTest::off:
    case DepthTest::always:
      break;
  }
  return GL_ALWAYS;
}

void applyBlend(Blend blend) {
  enable(GL_BLEND, blend != Blend::off);
  if (blend == Blend::over) {
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  } else if (blend == Blend::erase) {
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  } else if (blend == Blend::maximum) {
    glBlendEquation(GL_MAX);
    glBlendFunc(GL_ONE, GL_ONE);
  }
}

/// Tells whether that many channels are enough for the area's pixels.
bool holds(std::size_t channels, const PixelRect& area) {
  constexpr std::size_t perPixel = 4;
  return !area.empty() && channels >= std::size_t(area.width) * area.height * perPixel;
}

void bindCopy(const Target& from, const Target& to) {
  // Both are bound first: after a page was shown, Chromium takes one of the two for bound that is
  // not, and refuses to copy a framebuffer to itself.
  glBindFramebuffer(GL_FRAMEBUFFER, to.handle());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.handle());
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

Result<std::unique_ptr<Device>> Device::create() {
  std::unique_ptr<Device> device(new Device);
  const std::string version = text(GL_VERSION);
  if (version.empty())
    return Error{.reason = "no OpenGL context is current",
                 .remedy = "Make one current before asking for a picture"};
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  const bool es = version.starts_with("OpenGL ES");
  const std::string number = std::to_string(major) + "." + std::to_string(minor);
  device->m_driver = text(GL_RENDERER) + (es ? ", OpenGL ES " : ", OpenGL ") + number;
  device->m_software = isSoftware(rendererName());
  if (es ? major < 3 : major * 10 + minor < 33)
    return Error{.reason = "the driver " + device->m_driver +
                           " is too old: OpenGL 3.3 or OpenGL ES 3.0 is needed",
                 .remedy = "Update the graphics driver, or install Mesa (libgl1-mesa-dri)"};
  device->m_dialect = es ? Dialect::es300 : Dialect::desktop330;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &device->m_limits.textureSide);
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  device->m_limits.viewportSide = std::min(viewport[0], viewport[1]);
  return device;
}

void Device::clear(const Target& target, const Clear& what) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.handle());
  enable(GL_SCISSOR_TEST, what.area.has_value());
  if (what.area)
    glScissor(what.area->x, what.area->y, what.area->width, what.area->height);
  GLbitfield bits = 0;
  if (what.colour) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(what.colour->r, what.colour->g, what.colour->b, what.colour->a);
    bits |= GL_COLOR_BUFFER_BIT;
  }
  if (what.depth) {
    glDepthMask(GL_TRUE);
#ifdef __EMSCRIPTEN__
    glClearDepthf(*what.depth);
#else
    glClearDepth(double(*what.depth));
#endif
    bits |= GL_DEPTH_BUFFER_BIT;
  }
  glClear(bits);
}

void Device::apply(const Draw& draw) {
  const DrawState& state = draw.state;
  glBindFramebuffer(GL_FRAMEBUFFER, draw.target.handle());
  glViewport(state.viewport.x, state.viewport.y, state.viewport.width, state.viewport.height);
  enable(GL_SCISSOR_TEST, state.scissor.has_value());
  if (state.scissor)
    glScissor(state.scissor->x, state.scissor->y, state.scissor->width, state.scissor->height);
  enable(GL_DEPTH_TEST, state.depth != DepthTest::off);
  glDepthFunc(depthFunction(state.depth));
  glDepthMask(state.writeDepth ? GL_TRUE : GL_FALSE);
  const GLboolean colour = state.writeColour ? GL_TRUE : GL_FALSE;
  glColorMask(colour, colour, colour, colour);
  applyBlend(state.blend);
  enable(GL_CULL_FACE, state.cull == Cull::back);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glDisable(GL_STENCIL_TEST);
  glUseProgram(draw.program.handle());
  glBindVertexArray(draw.geometry.handle());
}

void Device::triangles(const Draw& draw, std::size_t count) {
  if (count == 0)
    return;
  apply(draw);
  if (draw.geometry.indexed())
    glDrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT, nullptr);
  else
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(count));
  glBindVertexArray(0);
}

void Device::quads(const Draw& draw, std::size_t instances) {
  if (instances == 0)
    return;
  apply(draw);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(instances));
  glBindVertexArray(0);
}

void Device::copyDepth(const Target& from, const Target& to, const PixelRect& area) {
  bindCopy(from, to);
  glBlitFramebuffer(area.x, area.y, area.right(), area.top(), area.x, area.y, area.right(),
                    area.top(), GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void Device::copyColour(const Target& from, const PixelRect& area, const Target& to,
                        const PixelRect& place) {
  const bool halved = area.width == 2 * place.width && area.height == 2 * place.height;
  assert(halved || (area.width == place.width && area.height == place.height));
  bindCopy(from, to);
  glBlitFramebuffer(area.x, area.y, area.right(), area.top(), place.x, place.y, place.right(),
                    place.top(), GL_COLOR_BUFFER_BIT, halved ? GL_LINEAR : GL_NEAREST);
}

Status Device::read(const Target& target, const PixelRect& area, std::span<std::byte> rgba) {
  if (!holds(rgba.size(), area))
    return misfit(rgba.size_bytes(), area);
  glBindFramebuffer(GL_FRAMEBUFFER, target.handle());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return Unit{};
}

Status Device::read(const Target& target, const PixelRect& area, std::span<std::uint16_t> rgba) {
  if (!holds(rgba.size(), area))
    return misfit(rgba.size_bytes(), area);
  glBindFramebuffer(GL_FRAMEBUFFER, target.handle());
  glPixelStorei(GL_PACK_ALIGNMENT, 2);
  glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_SHORT, rgba.data());
  return Unit{};
}

void Device::finish() {
  glFinish();
}

}  // namespace sline::render::gpu
