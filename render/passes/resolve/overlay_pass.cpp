// SPDX-License-Identifier: Apache-2.0
#include "render/passes/resolve/overlay_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

Result<std::unique_ptr<OverlayPass>> OverlayPass::create(gpu::Dialect dialect) {
  using gpu::UniformType;
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect,
                                          {.name = "overlay",
                                           .vertexFile = "wipe.vert.glsl",
                                           .fragmentFile = "overlay.frag.glsl",
                                           .uniforms = {{"targetSize", UniformType::vec2},
                                                        {"colours", UniformType::texture},
                                                        {"corner", UniformType::ivec2}}}));
  std::unique_ptr<OverlayPass> pass(new OverlayPass);
  pass->m_program = std::move(program);
  return pass;
}

void OverlayPass::draw(gpu::Device& device, const gpu::Target& target, const Overlay& overlay) {
  if (overlay.rectangles.empty())
    return;
  m_program->set("colours", overlay.colours);
  m_program->set("corner", overlay.corner);
  m_rectangles.draw(device, target, *m_program, overlay.rectangles, {.blend = gpu::Blend::over});
}

}  // namespace sline::render::passes
