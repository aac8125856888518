// SPDX-License-Identifier: Apache-2.0
#include "render/passes/hatching/hatching_pass.h"

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

using gpu::UniformType;

gpu::ProgramRecipe fieldRecipe() {
  return {.name = "hatching fields",
          .vertexFile = "hatching_field.vert.glsl",
          .fragmentFile = "hatching_field.frag.glsl",
          .uniforms = {{"viewProjection", UniformType::mat4},
                       {"pictureSize", UniformType::vec2},
                       {"layer", UniformType::vec4},
                       {"eye", UniformType::vec4},
                       {"shapeScale", UniformType::real},
                       {"filigree", UniformType::real},
                       {"grid", UniformType::vec4},
                       {"surfaceDepth", UniformType::texture},
                       {"toAtlas", UniformType::ivec2},
                       {"weight", UniformType::vec3},
                       {"twoSided", UniformType::integer}}};
}

gpu::ProgramRecipe searchRecipe() {
  return {.name = "hatching search",
          .vertexFile = "hatching_search.vert.glsl",
          .fragmentFile = "hatching_search.frag.glsl",
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

HatchingPass::HatchingPass() : m_rectangle({}, nullptr, "rectangle") {}

Result<std::unique_ptr<HatchingPass>> HatchingPass::create(gpu::Dialect dialect) {
  std::unique_ptr<HatchingPass> pass(new HatchingPass);
  auto field = gpu::Program::create(shaderFiles(), dialect, fieldRecipe());
  if (!field)
    return field.error();
  auto search = gpu::Program::create(shaderFiles(), dialect, searchRecipe());
  if (!search)
    return search.error();
  pass->m_field = std::move(*field);
  pass->m_search = std::move(*search);
  return pass;
}

void HatchingPass::drawFields(gpu::Device& device, const HatchingFields& to,
                              const gpu::Texture& surfaceDepths, const SurfaceView& view,
                              const HatchingDraw& draw) const {
  const SurfaceDraw& surface = draw.surface;
  const PixelRect here{0, 0, surface.slot.width, surface.slot.height};
  device.clear(to.target, {.depth = 1.0f, .area = here});
  m_field->set("viewProjection", view.viewProjection);
  m_field->set("pictureSize", view.pictureSize);
  m_field->set("layer", glm::vec4(float(surface.layer.x), float(surface.layer.y),
                                  float(surface.layer.width), float(surface.layer.height)));
  m_field->set("eye", view.eye);
  m_field->set("shapeScale", shapeScale);
  m_field->set("filigree", surface.fill.filigree);
  m_field->set("grid", glm::vec4(draw.gridCorner, draw.cell));
  m_field->set("surfaceDepth", surfaceDepths);
  m_field->set("toAtlas", glm::ivec2(surface.slot.x, surface.slot.y));
  m_field->set("weight",
               glm::vec3(draw.feature / surface.fill.filigree, draw.threshold, draw.opacity));
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

void HatchingPass::search(gpu::Device& device, const gpu::Target& target,
                          const HatchingFields& from, const HatchingDraw& draw) const {
  const PixelRect& slot = draw.surface.slot;
  m_search->set("fields", from.fields);
  m_search->set("depths", from.depths);
  m_search->set("origin", glm::ivec2(slot.x, slot.y));
  m_search->set("extent", glm::ivec2(slot.width, slot.height));
  m_search->set("projection", draw.projection);
  m_search->set("longest", longestSearch);
  m_search->set("stride", draw.stride);
  m_search->set("contourJump", draw.contourJump);
  const gpu::DrawState state{.viewport = slot,
                             .scissor = slot,
                             .depth = gpu::DepthTest::always,
                             .writeDepth = true,
                             .blend = gpu::Blend::maximum};
  device.quads({target, *m_search, m_rectangle, state}, 1);
}

}  // namespace sline::render::passes
