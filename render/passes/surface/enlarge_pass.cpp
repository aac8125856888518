// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface/enlarge_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

EnlargePass::EnlargePass()
    : m_rectangles(gpu::BufferKind::vertices, "enlarged rectangles"),
      m_geometry({{.buffer = &m_rectangles,
                   .stride = sizeof(PixelRect),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0}},
                   .perInstance = true}},
                 nullptr, "enlarged rectangles") {}

Result<std::unique_ptr<EnlargePass>> EnlargePass::create(gpu::Dialect dialect) {
  using gpu::UniformType;
  auto program = gpu::Program::create(shaderFiles(), dialect,
                                      {.name = "enlarge",
                                       .vertexFile = "wipe.vert.glsl",
                                       .fragmentFile = "enlarge.frag.glsl",
                                       .uniforms = {{"targetSize", UniformType::vec2},
                                                    {"colours", UniformType::texture},
                                                    {"depths", UniformType::texture},
                                                    {"pixelStep", UniformType::real}}});
  if (!program)
    return program.error();
  std::unique_ptr<EnlargePass> pass(new EnlargePass);
  pass->m_program = std::move(*program);
  return pass;
}

void EnlargePass::draw(gpu::Device& device, const gpu::Target& target,
                       const Enlargement& enlargement) {
  if (enlargement.rectangles.empty())
    return;
  const gpu::TextureSize size = target.size();
  m_rectangles.stream(std::as_bytes(enlargement.rectangles));
  m_program->set("targetSize", glm::vec2(float(size.width), float(size.height)));
  m_program->set("colours", enlargement.colours);
  m_program->set("depths", enlargement.depths);
  m_program->set("pixelStep", float(enlargement.step));
  device.quads({target,
                *m_program,
                m_geometry,
                {.viewport = {0, 0, size.width, size.height},
                 .depth = gpu::DepthTest::always,
                 .writeDepth = true}},
               enlargement.rectangles.size());
}

}  // namespace sline::render::passes
