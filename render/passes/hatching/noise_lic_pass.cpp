// SPDX-License-Identifier: Apache-2.0
#include "render/passes/hatching/noise_lic_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

gpu::ProgramRecipe noiseFieldRecipe() {
  using gpu::UniformType;
  return {.name = "noise fields",
          .vertexFile = "noise_lic_field.vert.glsl",
          .fragmentFile = "noise_lic_field.frag.glsl",
          .uniforms = {{"viewProjection", UniformType::mat4},
                       {"pictureSize", UniformType::vec2},
                       {"layer", UniformType::vec4},
                       {"eye", UniformType::vec4},
                       {"shapeScale", UniformType::real},
                       {"grid", UniformType::vec4},
                       {"surfaceDepth", UniformType::texture},
                       {"toAtlas", UniformType::ivec2},
                       {"light", UniformType::vec3},
                       {"shading", UniformType::vec3},
                       {"twoSided", UniformType::integer}}};
}

gpu::ProgramRecipe convolutionRecipe() {
  using gpu::UniformType;
  return {.name = "noise convolution",
          .vertexFile = "hatching_search.vert.glsl",
          .fragmentFile = "noise_lic.frag.glsl",
          .uniforms = {{"fields", UniformType::intTexture},
                       {"depths", UniformType::texture},
                       {"origin", UniformType::ivec2},
                       {"extent", UniformType::ivec2},
                       {"projection", UniformType::vec4},
                       {"longest", UniformType::integer},
                       {"stride", UniformType::real},
                       {"contourJump", UniformType::real}}};
}

}  // namespace

NoiseLicPass::NoiseLicPass() : m_rectangle({}, nullptr, "rectangle") {}

Result<std::unique_ptr<NoiseLicPass>> NoiseLicPass::create(gpu::Dialect dialect) {
  std::unique_ptr<NoiseLicPass> pass(new NoiseLicPass);
  auto field = TRY(gpu::Program::create(shaderFiles(), dialect, noiseFieldRecipe()));
  auto convolution = TRY(gpu::Program::create(shaderFiles(), dialect, convolutionRecipe()));
  pass->m_field = std::move(field);
  pass->m_convolution = std::move(convolution);
  return pass;
}

void NoiseLicPass::drawFields(gpu::Device& device, const HatchingFields& to,
                              const gpu::Texture& surfaceDepths, const SurfaceView& view,
                              const NoiseLicDraw& draw) const {
  setSlot(*m_field, surfaceDepths, view, draw.surface);
  m_field->set("grid", glm::vec4(draw.middle, draw.cell));
  m_field->set("light", draw.light);
  m_field->set("shading", glm::vec3(draw.leastShade, draw.fromEye, draw.entered));
  drawSlot(device, to, *m_field, draw.surface);
}

void NoiseLicPass::convolve(gpu::Device& device, const gpu::Target& target,
                            const HatchingFields& from, const NoiseLicDraw& draw) const {
  drawWalk(device, target, from,
           {.program = *m_convolution,
            .rectangle = m_rectangle,
            .slot = draw.surface.slot,
            .projection = draw.projection,
            .longest = longest,
            .stride = draw.stride,
            .contourJump = draw.contourJump});
}

}  // namespace sline::render::passes
