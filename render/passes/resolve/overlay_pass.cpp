// SPDX-License-Identifier: Apache-2.0
#include "render/passes/resolve/overlay_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

OverlayPass::OverlayPass()
    : m_rectangles(gpu::BufferKind::vertices, "overlaid rectangles"),
      m_geometry({{.buffer = &m_rectangles,
                   .stride = sizeof(PixelRect),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0}},
                   .perInstance = true}},
                 nullptr, "overlaid rectangles") {}

Result<std::unique_ptr<OverlayPass>> OverlayPass::create(gpu::Dialect dialect) {
  using gpu::UniformType;
  auto program = gpu::Program::create(shaderFiles(), dialect,
                                      {.name = "overlay",
                                       .vertexFile = "wipe.vert.glsl",
                                       .fragmentFile = "overlay.frag.glsl",
                                       .uniforms = {{"targetSize", UniformType::vec2},
                                                    {"colours", UniformType::texture},
                                                    {"corner", UniformType::ivec2}}});
  if (!program)
    return program.error();
  std::unique_ptr<OverlayPass> pass(new OverlayPass);
  pass->m_program = std::move(*program);
  return pass;
}

void OverlayPass::draw(gpu::Device& device, const gpu::Target& target, const Overlay& overlay) {
  if (overlay.rectangles.empty())
    return;
  const gpu::TextureSize size = target.size();
  m_rectangles.stream(std::as_bytes(overlay.rectangles));
  m_program->set("targetSize", glm::vec2(float(size.width), float(size.height)));
  m_program->set("colours", overlay.colours);
  m_program->set("corner", overlay.corner);
  device.quads({target,
                *m_program,
                m_geometry,
                {.viewport = {0, 0, size.width, size.height}, .blend = gpu::Blend::over}},
               overlay.rectangles.size());
}

}  // namespace sline::render::passes
