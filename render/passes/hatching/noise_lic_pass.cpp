// SPDX-License-Identifier: Apache-2.0
#include "render/passes/hatching/noise_lic_pass.h"

#include <span>

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
  auto field = gpu::Program::create(shaderFiles(), dialect, noiseFieldRecipe());
  if (!field)
    return field.error();
  auto convolution = gpu::Program::create(shaderFiles(), dialect, convolutionRecipe());
  if (!convolution)
    return convolution.error();
  pass->m_field = std::move(*field);
  pass->m_convolution = std::move(*convolution);
  return pass;
}

void NoiseLicPass::drawFields(gpu::Device& device, const HatchingFields& to,
                              const gpu::Texture& surfaceDepths, const SurfaceView& view,
                              const NoiseLicDraw& draw) const {
  const SurfaceDraw& surface = draw.surface;
  const PixelRect here{0, 0, surface.slot.width, surface.slot.height};
  device.clear(to.target, {.depth = 1.0f, .area = here});
  m_field->set("viewProjection", view.viewProjection);
  m_field->set("pictureSize", view.pictureSize);
  m_field->set("layer", glm::vec4(float(surface.layer.x), float(surface.layer.y),
                                  float(surface.layer.width), float(surface.layer.height)));
  m_field->set("eye", view.eye);
  m_field->set("shapeScale", shapeScale);
  m_field->set("grid", glm::vec4(draw.middle, draw.cell));
  m_field->set("surfaceDepth", surfaceDepths);
  m_field->set("toAtlas", glm::ivec2(surface.slot.x, surface.slot.y));
  m_field->set("light", draw.light);
  m_field->set("shading", glm::vec3(draw.leastShade, draw.fromEye, draw.entered));
  m_field->set("twoSided", surface.fill.twoSided ? 1 : 0);
  const gpu::DrawState state{
      .viewport = here, .scissor = here, .depth = gpu::DepthTest::less, .writeDepth = true};
  if (surface.visible.empty()) {
    device.triangles({to.target, *m_field, surface.surface.geometry(), state}, surface.ranges);
    return;
  }
  surface.surface.showOnly(surface.visible);
  const gpu::DrawRange all{0, std::uint32_t(surface.visible.size())};
  device.triangles({to.target, *m_field, surface.surface.visibleGeometry(), state},
                   std::span(&all, 1));
}

void NoiseLicPass::convolve(gpu::Device& device, const gpu::Target& target,
                            const HatchingFields& from, const NoiseLicDraw& draw) const {
  const PixelRect& slot = draw.surface.slot;
  m_convolution->set("fields", from.fields);
  m_convolution->set("depths", from.depths);
  m_convolution->set("origin", glm::ivec2(slot.x, slot.y));
  m_convolution->set("extent", glm::ivec2(slot.width, slot.height));
  m_convolution->set("projection", draw.projection);
  m_convolution->set("longest", longest);
  m_convolution->set("stride", draw.stride);
  m_convolution->set("contourJump", draw.contourJump);
  const gpu::DrawState state{.viewport = slot,
                             .scissor = slot,
                             .depth = gpu::DepthTest::always,
                             .writeDepth = true,
                             .blend = gpu::Blend::maximum};
  device.quads({target, *m_convolution, m_rectangle, state}, 1);
}

}  // namespace sline::render::passes
