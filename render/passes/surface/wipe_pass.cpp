// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface/wipe_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

static_assert(sizeof(PixelRect) == 4 * sizeof(std::int32_t));

WipePass::WipePass()
    : m_rectangles(gpu::BufferKind::vertices, "wiped rectangles"),
      m_geometry({{.buffer = &m_rectangles,
                   .stride = sizeof(PixelRect),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0}},
                   .perInstance = true}},
                 nullptr, "wiped rectangles") {}

Result<std::unique_ptr<WipePass>> WipePass::create(gpu::Dialect dialect) {
  auto program = gpu::Program::create(shaderFiles(), dialect,
                                      {.name = "wipe",
                                       .vertexFile = "wipe.vert.glsl",
                                       .fragmentFile = "wipe.frag.glsl",
                                       .uniforms = {{"targetSize", gpu::UniformType::vec2}}});
  if (!program)
    return program.error();
  std::unique_ptr<WipePass> pass(new WipePass);
  pass->m_program = std::move(*program);
  return pass;
}

void WipePass::draw(gpu::Device& device, const gpu::Target& target, const Wipe& wipe) {
  if (wipe.rectangles.empty() || !(wipe.colour || wipe.depth))
    return;
  const gpu::TextureSize size = target.size();
  m_rectangles.stream(std::as_bytes(wipe.rectangles));
  m_program->set("targetSize", glm::vec2(float(size.width), float(size.height)));
  const gpu::DrawState state{.viewport = {0, 0, size.width, size.height},
                             .depth = wipe.depth ? gpu::DepthTest::always : gpu::DepthTest::off,
                             .writeDepth = wipe.depth,
                             .writeColour = wipe.colour};
  device.quads({target, *m_program, m_geometry, state}, wipe.rectangles.size());
}

}  // namespace sline::render::passes
