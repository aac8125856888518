// SPDX-License-Identifier: Apache-2.0
#include "render/passes/plain_phong/plain_phong_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

Result<std::unique_ptr<PlainPhongPass>> PlainPhongPass::create(gpu::Dialect dialect) {
  using gpu::UniformType;
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect,
                                          {.name = "plain phong",
                                           .vertexFile = "plain_phong.vert.glsl",
                                           .fragmentFile = "plain_phong.frag.glsl",
                                           .uniforms = {{"viewProjection", UniformType::mat4},
                                                        {"eye", UniformType::vec4},
                                                        {"colour", UniformType::vec3}}}));
  std::unique_ptr<PlainPhongPass> pass(new PlainPhongPass);
  pass->m_program = std::move(program);
  return pass;
}

void PlainPhongPass::draw(gpu::Device& device, const gpu::Target& target, const View& view,
                          const SurfaceGeometry& surface, const glm::vec3& colour) const {
  m_program->set("viewProjection", view.viewProjection);
  m_program->set("eye", view.eye);
  m_program->set("colour", colour);
  const gpu::DrawState state{.viewport = {0, 0, target.size().width, target.size().height},
                             .depth = gpu::DepthTest::less,
                             .writeDepth = true};
  device.triangles({target, *m_program, surface.geometry(), state}, surface.indexCount());
}

}  // namespace sline::render::passes
