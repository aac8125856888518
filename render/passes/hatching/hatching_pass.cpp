// SPDX-License-Identifier: Apache-2.0
#include "render/passes/hatching/hatching_pass.h"

#include <cstdint>
#include <span>

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

void setSlot(const gpu::Program& program, const gpu::Texture& surfaceDepths,
             const SurfaceView& view, const SurfaceDraw& surface) {
  program.set("viewProjection", view.viewProjection);
  program.set("pictureSize", view.pictureSize);
  program.set("layer", glm::vec4(float(surface.layer.x), float(surface.layer.y),
                                 float(surface.layer.width), float(surface.layer.height)));
  program.set("eye", view.eye);
  program.set("shapeScale", shapeScale);
  program.set("surfaceDepth", surfaceDepths);
  program.set("toAtlas", glm::ivec2(surface.slot.x, surface.slot.y));
  program.set("twoSided", surface.fill.twoSided ? 1 : 0);
}

void drawSlot(gpu::Device& device, const HatchingFields& to, const gpu::Program& program,
              const SurfaceDraw& surface) {
  const PixelRect here{0, 0, surface.slot.width, surface.slot.height};
  device.clear(to.target, {.depth = 1.0f, .area = here});
  const gpu::DrawState state{
      .viewport = here, .scissor = here, .depth = gpu::DepthTest::less, .writeDepth = true};
  surface.surface.setTriangles(surface.triangles);
  device.triangles({to.target, program, surface.surface.geometry(), state},
                   surface.triangles.size());
}

void drawWalk(gpu::Device& device, const gpu::Target& target, const HatchingFields& from,
              const SlotWalk& walk) {
  const PixelRect& slot = walk.slot;
  walk.program.set("fields", from.fields);
  walk.program.set("depths", from.depths);
  walk.program.set("origin", glm::ivec2(slot.x, slot.y));
  walk.program.set("extent", glm::ivec2(slot.width, slot.height));
  walk.program.set("projection", walk.projection);
  walk.program.set("longest", walk.longest);
  walk.program.set("stride", walk.stride);
  walk.program.set("contourJump", walk.contourJump);
  const gpu::DrawState state{.viewport = slot,
                             .scissor = slot,
                             .depth = gpu::DepthTest::always,
                             .writeDepth = true,
                             .blend = gpu::Blend::maximum};
  device.quads({target, walk.program, walk.rectangle, state}, 1);
}

HatchingPass::HatchingPass() : m_rectangle({}, nullptr, "rectangle") {}

Result<std::unique_ptr<HatchingPass>> HatchingPass::create(gpu::Dialect dialect) {
  std::unique_ptr<HatchingPass> pass(new HatchingPass);
  auto field = TRY(gpu::Program::create(shaderFiles(), dialect, fieldRecipe()));
  auto search = TRY(gpu::Program::create(shaderFiles(), dialect, searchRecipe()));
  pass->m_field = std::move(field);
  pass->m_search = std::move(search);
  return pass;
}

void HatchingPass::drawFields(gpu::Device& device, const HatchingFields& to,
                              const gpu::Texture& surfaceDepths, const SurfaceView& view,
                              const HatchingDraw& draw) const {
  const float filigree = draw.surface.fill.filigree;
  setSlot(*m_field, surfaceDepths, view, draw.surface);
  m_field->set("filigree", filigree);
  m_field->set("grid", glm::vec4(draw.gridCorner, draw.cell));
  m_field->set("weight", glm::vec3(draw.feature / filigree, draw.threshold, draw.opacity));
  drawSlot(device, to, *m_field, draw.surface);
}

void HatchingPass::search(gpu::Device& device, const gpu::Target& target,
                          const HatchingFields& from, const HatchingDraw& draw) const {
  drawWalk(device, target, from,
           {.program = *m_search,
            .rectangle = m_rectangle,
            .slot = draw.surface.slot,
            .projection = draw.projection,
            .longest = longestSearch,
            .stride = draw.stride,
            .contourJump = draw.contourJump});
}

}  // namespace sline::render::passes
