// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface/enlarge_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

Result<std::unique_ptr<EnlargePass>> EnlargePass::create(gpu::Dialect dialect) {
  using gpu::UniformType;
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect,
                                          {.name = "enlarge",
                                           .vertexFile = "wipe.vert.glsl",
                                           .fragmentFile = "enlarge.frag.glsl",
                                           .uniforms = {{"targetSize", UniformType::vec2},
                                                        {"colours", UniformType::texture},
                                                        {"depths", UniformType::texture},
                                                        {"pixelStep", UniformType::real}}}));
  std::unique_ptr<EnlargePass> pass(new EnlargePass);
  pass->m_program = std::move(program);
  return pass;
}

void EnlargePass::draw(gpu::Device& device, const gpu::Target& target,
                       const Enlargement& enlargement) {
  if (enlargement.rectangles.empty())
    return;
  m_program->set("colours", enlargement.colours);
  m_program->set("depths", enlargement.depths);
  m_program->set("pixelStep", float(enlargement.step));
  m_rectangles.draw(device, target, *m_program, enlargement.rectangles,
                    {.depth = gpu::DepthTest::always, .writeDepth = true});
}

}  // namespace sline::render::passes
