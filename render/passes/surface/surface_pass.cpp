// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface/surface_pass.h"

#include <algorithm>
#include <array>

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

using gpu::UniformType;

gpu::ProgramRecipe flatRecipe() {
  return {.name = "flat surface",
          .vertexFile = "flat.vert.glsl",
          .fragmentFile = "flat.frag.glsl",
          .uniforms = {{"viewProjection", UniformType::mat4},
                       {"pictureSize", UniformType::vec2},
                       {"layer", UniformType::vec4},
                       {"colour", UniformType::vec4}}};
}

gpu::ProgramRecipe phongRecipe() {
  return {.name = "shaded surface",
          .vertexFile = "surface.vert.glsl",
          .fragmentFile = "surface.frag.glsl",
          .uniforms = {{"viewProjection", UniformType::mat4},
                       {"pictureSize", UniformType::vec2},
                       {"layer", UniformType::vec4},
                       {"eye", UniformType::vec4},
                       {"shapeScale", UniformType::real},
                       {"filigree", UniformType::real},
                       {"colour", UniformType::vec3},
                       {"wash", UniformType::vec4},
                       {"transition", UniformType::vec3},
                       {"twoSided", UniformType::integer},
                       {"darkGround", UniformType::integer},
                       {"leastFacing", UniformType::real},
                       {"key", UniformType::vec3}}};
}

/// Returns the program of surfaces over which Γ varies.
gpu::ProgramRecipe varyingRecipe() {
  gpu::ProgramRecipe recipe = phongRecipe();
  recipe.name = "surface shaded by its own gamma";
  recipe.vertexFile = "surface_gamma.vert.glsl";
  recipe.fragmentFile = "surface_gamma.frag.glsl";
  recipe.uniforms.push_back({"gamma", UniformType::real});
  recipe.uniforms.push_back({"stages[0]", UniformType::vec4});
  return recipe;
}

/// Returns the same program, but without the parts that sections cut away.
gpu::ProgramRecipe sectioned(gpu::ProgramRecipe recipe) {
  struct Cut {
    std::string_view whole;
    std::string_view name;
    std::string_view vertexFile;
    std::string_view fragmentFile;
  };
  constexpr std::array cuts{
      Cut{"flat.frag.glsl", "cut flat surface", "flat_cut.vert.glsl", "flat_cut.frag.glsl"},
      Cut{"surface.frag.glsl", "cut shaded surface", "surface_cut.vert.glsl",
          "surface_cut.frag.glsl"},
      Cut{"surface_gamma.frag.glsl", "cut surface shaded by its own gamma",
          "surface_gamma_cut.vert.glsl", "surface_gamma_cut.frag.glsl"}};
  const auto cut = std::find_if(cuts.begin(), cuts.end(),
                                [&](const Cut& each) { return each.whole == recipe.fragmentFile; });
  recipe.name = cut->name;
  recipe.vertexFile = cut->vertexFile;
  recipe.fragmentFile = cut->fragmentFile;
  recipe.uniforms.push_back({"sections[0]", UniformType::vec4});
  recipe.uniforms.push_back({"sectionCount", UniformType::integer});
  return recipe;
}

}  // namespace

Result<std::unique_ptr<SurfacePass>> SurfacePass::create(gpu::Dialect dialect) {
  std::unique_ptr<SurfacePass> pass(new SurfacePass);
  pass->m_stages = fillStages();
  const auto make = [dialect](std::unique_ptr<gpu::Program>& program,
                              const gpu::ProgramRecipe& recipe) -> Status {
    program = TRY(gpu::Program::create(shaderFiles(), dialect, recipe));
    return Unit{};
  };
  for (const Status& status :
       {make(pass->m_flat, flatRecipe()), make(pass->m_phong, phongRecipe()),
        make(pass->m_flatCut, sectioned(flatRecipe())),
        make(pass->m_phongCut, sectioned(phongRecipe())), make(pass->m_varying, varyingRecipe()),
        make(pass->m_varyingCut, sectioned(varyingRecipe()))})
    if (!status)
      return status.error();
  return pass;
}

void SurfacePass::draw(gpu::Device& device, const gpu::Target& target, const SurfaceView& view,
                       const SurfaceDraw& draw) const {
  const SurfaceFill& fill = draw.fill;
  const bool shaded = fill.kind == SurfaceFill::Kind::phong;
  const bool cut = !draw.sections.empty();
  const bool varies = shaded && fill.gammaOffsets;
  const gpu::Program& program = varies   ? (cut ? *m_varyingCut : *m_varying)
                                : shaded ? (cut ? *m_phongCut : *m_phong)
                                         : (cut ? *m_flatCut : *m_flat);
  if (cut) {
    program.set("sections[0]", draw.sections);
    program.set("sectionCount", int(draw.sections.size()));
  }
  program.set("viewProjection", view.viewProjection);
  program.set("pictureSize", view.pictureSize);
  program.set("layer", glm::vec4(float(draw.layer.x), float(draw.layer.y), float(draw.layer.width),
                                 float(draw.layer.height)));
  if (shaded) {
    program.set("eye", view.eye);
    program.set("shapeScale", shapeScale);
    program.set("filigree", fill.filigree);
    program.set("colour", fill.colour);
    program.set("wash", fill.wash);
    program.set("transition", glm::vec3(fill.shading, fill.complete, fill.opacity));
    if (varies) {
      program.set("gamma", fill.gamma);
      program.set("stages[0]", std::span<const glm::vec4>(m_stages));
    }
    program.set("twoSided", fill.twoSided ? 1 : 0);
    program.set("darkGround", fill.darkGround ? 1 : 0);
    program.set("leastFacing", fill.leastFacing);
    program.set("key", view.key);
  } else {
    program.set("colour", fill.wash);
  }
  gpu::DrawState state{.viewport = draw.slot,
                       .scissor = draw.slot,
                       .depth = gpu::DepthTest::less,
                       .writeDepth = true,
                       .writeColour = fill.kind != SurfaceFill::Kind::depthOnly};
  if (draw.whole) {
    state.cull = draw.cullsBack ? gpu::Cull::back : gpu::Cull::none;
    device.triangles({target, program, draw.surface.whole(), state}, draw.surface.wholeCount());
    return;
  }
  draw.surface.setTriangles(draw.triangles);
  device.triangles({target, program, draw.surface.geometry(), state}, draw.triangles.size());
}

}  // namespace sline::render::passes
