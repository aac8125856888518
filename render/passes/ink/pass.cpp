// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ink/pass.h"

#include <cstddef>

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

gpu::ProgramRecipe recipe() {
  using gpu::UniformType;
  return {.name = "ink",
          .vertexFile = "ink.vert.glsl",
          .fragmentFile = "ink.frag.glsl",
          .uniforms = {{"layer", UniformType::vec4},
                       {"surfaceDepth", UniformType::texture},
                       {"slot", UniformType::ivec4},
                       {"toAtlas", UniformType::ivec2},
                       {"projection", UniformType::vec4},
                       {"probe", UniformType::real},
                       {"reach", UniformType::vec2},
                       {"sheet", UniformType::real},
                       {"edges", UniformType::integer},
                       {"paint", UniformType::vec4},
                       {"key", UniformType::vec3}}};
}

std::vector<gpu::Stream> streams(const gpu::Buffer& buffer) {
  using gpu::AttributeType;
  return {{.buffer = &buffer,
           .stride = sizeof(InkSegment),
           .attributes = {{0, 4, AttributeType::float32, offsetof(InkSegment, a)},
                          {1, 4, AttributeType::float32, offsetof(InkSegment, depthA)},
                          {2, 4, AttributeType::float32, offsetof(InkSegment, outwardA)},
                          {3, 4, AttributeType::float32, offsetof(InkSegment, halfWidthA)}},
           .perInstance = true}};
}

}  // namespace

InkPass::InkPass()
    : m_segments(gpu::BufferKind::vertices, "ink segments"),
      m_geometry(streams(m_segments), nullptr, "ink") {}

Result<std::unique_ptr<InkPass>> InkPass::create(gpu::Dialect dialect) {
  auto program = gpu::Program::create(shaderFiles(), dialect, recipe());
  if (!program)
    return program.error();
  std::unique_ptr<InkPass> pass(new InkPass);
  pass->m_program = std::move(*program);
  return pass;
}

void InkPass::upload(std::span<const InkSegment> segments) {
  m_segments.stream(std::as_bytes(segments));
}

void InkPass::draw(gpu::Device& device, const gpu::Target& target, const gpu::Texture& surfaceDepth,
                   const InkDraw& draw) {
  if (draw.count == 0)
    return;
  m_program->set("layer", glm::vec4(float(draw.layer.x), float(draw.layer.y),
                                    float(draw.layer.width), float(draw.layer.height)));
  m_program->set("surfaceDepth", surfaceDepth);
  m_program->set("slot",
                 glm::ivec4(draw.slot.x, draw.slot.y, draw.slot.right() - 1, draw.slot.top() - 1));
  m_program->set("toAtlas", glm::ivec2(draw.slot.x - draw.layer.x, draw.slot.y - draw.layer.y));
  m_program->set("projection", draw.projection);
  m_program->set("probe", draw.probe);
  m_program->set("reach", draw.reach);
  m_program->set("sheet", draw.sheet);
  m_program->set("edges", draw.edge ? 1 : 0);
  m_program->set("paint", draw.edge.value_or(glm::vec4(0.0f)));
  m_program->set("key", draw.key);
  m_geometry.startInstancesAt(draw.first);
  // Segments come farthest first, so the depth that stays is the nearest line's although every
  // coverage counts.
  const gpu::DrawState state{.viewport = draw.slot,
                             .scissor = draw.slot,
                             .depth = gpu::DepthTest::always,
                             .writeDepth = true,
                             .blend = draw.edge ? gpu::Blend::over : gpu::Blend::maximum};
  device.quads({target, *m_program, m_geometry, state}, draw.count);
}

}  // namespace sline::render::passes
