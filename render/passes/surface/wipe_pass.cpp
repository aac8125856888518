// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface/wipe_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

Result<std::unique_ptr<WipePass>> WipePass::create(gpu::Dialect dialect) {
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect,
                                          {.name = "wipe",
                                           .vertexFile = "wipe.vert.glsl",
                                           .fragmentFile = "wipe.frag.glsl",
                                           .uniforms = {{"targetSize", gpu::UniformType::vec2}}}));
  std::unique_ptr<WipePass> pass(new WipePass);
  pass->m_program = std::move(program);
  return pass;
}

void WipePass::draw(gpu::Device& device, const gpu::Target& target, const Wipe& wipe) {
  if (wipe.rectangles.empty() || !(wipe.colour || wipe.depth))
    return;
  m_rectangles.draw(device, target, *m_program, wipe.rectangles,
                    {.depth = wipe.depth ? gpu::DepthTest::always : gpu::DepthTest::off,
                     .writeDepth = wipe.depth,
                     .writeColour = wipe.colour});
}

}  // namespace sline::render::passes
