// SPDX-License-Identifier: Apache-2.0
#include "render/passes/cap/cap_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

gpu::ProgramRecipe capRecipe() {
  using gpu::UniformType;
  return {.name = "cut face",
          .vertexFile = "cap.vert.glsl",
          .fragmentFile = "cap.frag.glsl",
          .uniforms = {{"viewProjection", UniformType::mat4},
                       {"pictureSize", UniformType::vec2},
                       {"layer", UniformType::vec4},
                       {"sections[0]", UniformType::vec4},
                       {"sectionCount", UniformType::integer},
                       {"colour", UniformType::vec4},
                       {"strokeColour", UniformType::vec4},
                       {"stripes", UniformType::vec4},
                       {"halfWidth", UniformType::real},
                       {"pixelStep", UniformType::real},
                       {"toMiddle", UniformType::vec2},
                       {"depthPlane", UniformType::vec3}}};
}

}  // namespace

CapGeometry::CapGeometry(std::span<const glm::vec3> points)
    : m_points(gpu::BufferKind::vertices, "cut face"),
      m_geometry({{.buffer = &m_points,
                   .stride = sizeof(glm::vec3),
                   .attributes = {{0, 3, gpu::AttributeType::float32, 0}}}},
                 nullptr, "cut face"),
      m_pointCount(std::uint32_t(points.size())) {
  m_points.fill(std::as_bytes(points));
}

Result<std::unique_ptr<CapPass>> CapPass::create(gpu::Dialect dialect) {
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect, capRecipe()));
  std::unique_ptr<CapPass> pass(new CapPass);
  pass->m_program = std::move(program);
  return pass;
}

void CapPass::draw(gpu::Device& device, const gpu::Target& target, const CapDraw& draw) const {
  const gpu::Program& program = *m_program;
  program.set("viewProjection", draw.viewProjection);
  program.set("pictureSize", draw.pictureSize);
  program.set("layer", glm::vec4(float(draw.layer.x), float(draw.layer.y), float(draw.layer.width),
                                 float(draw.layer.height)));
  program.set("sections[0]", draw.otherSections);
  program.set("sectionCount", int(draw.otherSections.size()));
  program.set("colour", draw.colour);
  program.set("strokeColour", draw.strokeColour);
  program.set("stripes", draw.stripes);
  program.set("halfWidth", draw.strokeHalfWidth);
  const float step = float(draw.layer.width) / float(draw.slot.width);
  program.set("pixelStep", step);
  program.set("toMiddle", glm::vec2(float(draw.layer.x), float(draw.layer.y)) -
                              step * glm::vec2(float(draw.slot.x), float(draw.slot.y)) -
                              0.5f * draw.pictureSize);
  program.set("depthPlane", draw.depthPlane);
  const gpu::DrawState state{.viewport = draw.slot,
                             .scissor = draw.slot,
                             .depth = gpu::DepthTest::less,
                             .writeDepth = true};
  device.triangles({target, program, draw.cap.geometry(), state}, draw.cap.pointCount());
}

}  // namespace sline::render::passes
