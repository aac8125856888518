// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ink/ink_pass.h"

#include <cstddef>
#include <optional>

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

gpu::ProgramRecipe inkRecipe(InkKind kind) {
  using gpu::UniformType;
  gpu::ProgramRecipe recipe{.name = "lines on surfaces",
                            .vertexFile = "ink.vert.glsl",
                            .fragmentFile = "surface_line.frag.glsl",
                            .uniforms = {{"layer", UniformType::vec4},
                                         {"surfaceDepth", UniformType::texture},
                                         {"surfaceStep", UniformType::real},
                                         {"slot", UniformType::ivec4},
                                         {"toAtlas", UniformType::ivec2},
                                         {"projection", UniformType::vec4}}};
  if (kind == InkKind::surfaceLines)
    return recipe;
  if (kind == InkKind::trims) {
    recipe.name = "trims of fills";
    recipe.vertexFile = "trim.vert.glsl";
    recipe.fragmentFile = "trim.frag.glsl";
    recipe.uniforms.pop_back();
    return recipe;
  }
  recipe.uniforms.push_back({"reach", UniformType::vec2});
  recipe.uniforms.push_back({"sheet", UniformType::real});
  if (kind == InkKind::contours || kind == InkKind::hidden) {
    recipe.name = kind == InkKind::contours ? "contours" : "hidden outlines";
    recipe.fragmentFile = "contour.frag.glsl";
    recipe.uniforms.push_back({"probe", UniformType::real});
    recipe.uniforms.push_back({"channel", UniformType::vec2});
  } else if (kind == InkKind::halos) {
    recipe.name = "halos";
    recipe.fragmentFile = "halo.frag.glsl";
  } else {
    recipe.name = "edges of fills";
    recipe.fragmentFile = "edge.frag.glsl";
    recipe.uniforms.push_back({"paint", UniformType::vec4});
    recipe.uniforms.push_back({"key", UniformType::vec3});
  }
  return recipe;
}

/// Returns the same program on rough paper; nothing for what is no ink. It is another, as software
/// rasterisers work out the paper even where it is smooth.
std::optional<gpu::ProgramRecipe> grainedRecipe(InkKind kind) {
  if (kind == InkKind::halos || kind == InkKind::edges || kind == InkKind::trims)
    return std::nullopt;
  gpu::ProgramRecipe recipe = inkRecipe(kind);
  recipe.fragmentFile = kind == InkKind::surfaceLines ? "surface_line_grained.frag.glsl"
                                                      : "contour_grained.frag.glsl";
  recipe.uniforms.push_back({"grain", gpu::UniformType::vec2});
  return recipe;
}

// The stored value of hidden ink that covers all; more means a halo (resolve.frag.glsl).
constexpr float hiddenCoverage = 0.5f;

/// A stroke as the shaders read it.
struct InkVertex {
  glm::vec2 a;
  glm::vec2 b;
  float depthA;
  float depthB;
  float tolerance;
  /// 0: a line on the surface; 1 … 2: a contour, 1 + the share of it that remains within the
  /// surface's own mask; below 0: hatching, minus the pixels over which its edge fades.
  float kind;
  glm::vec2 outwardA;
  glm::vec2 outwardB;
  glm::vec2 moveA;
  glm::vec2 moveB;
  float halfWidthA;
  float halfWidthB;
  float opacityA;
  float opacityB;
  float capA;
  float capB;
};

float kindOf(const Stroke& stroke) {
  switch (stroke.kind) {
    case StrokeKind::contour:
      return 1.0f + stroke.innerShare;
    case StrokeKind::hatching:
      return -stroke.softness;
    case StrokeKind::surfaceLine:
      break;
  }
  return 0.0f;
}

gpu::Blend blendOf(InkKind kind) {
  switch (kind) {
    case InkKind::edges:
      return gpu::Blend::over;
    case InkKind::trims:
      return gpu::Blend::erase;
    case InkKind::surfaceLines:
    case InkKind::contours:
    case InkKind::hidden:
    case InkKind::halos:
      break;
  }
  return gpu::Blend::maximum;
}

std::vector<gpu::Stream> streams(const gpu::Buffer& buffer) {
  using gpu::AttributeType;
  return {{.buffer = &buffer,
           .stride = sizeof(InkVertex),
           .attributes = {{0, 4, AttributeType::float32, offsetof(InkVertex, a)},
                          {1, 4, AttributeType::float32, offsetof(InkVertex, depthA)},
                          {2, 4, AttributeType::float32, offsetof(InkVertex, outwardA)},
                          {3, 4, AttributeType::float32, offsetof(InkVertex, halfWidthA)},
                          {4, 4, AttributeType::float32, offsetof(InkVertex, moveA)},
                          {5, 2, AttributeType::float32, offsetof(InkVertex, capA)}},
           .perInstance = true}};
}

}  // namespace

InkPass::InkPass()
    : m_segments(gpu::BufferKind::vertices, "ink segments"),
      m_geometry(streams(m_segments), nullptr, "ink") {}

Result<std::unique_ptr<InkPass>> InkPass::create(gpu::Dialect dialect) {
  std::unique_ptr<InkPass> pass(new InkPass);
  for (std::size_t i = 0; i < inkKindCount; ++i) {
    const auto kind = InkKind(i);
    auto program = gpu::Program::create(shaderFiles(), dialect, inkRecipe(kind));
    if (!program)
      return program.error();
    pass->m_programs[i] = std::move(*program);
    if (const auto recipe = grainedRecipe(kind)) {
      auto grained = gpu::Program::create(shaderFiles(), dialect, *recipe);
      if (!grained)
        return grained.error();
      pass->m_grained[i] = std::move(*grained);
    }
  }
  return pass;
}

void InkPass::upload(std::span<const Stroke> strokes) {
  std::vector<InkVertex> vertices;
  vertices.reserve(strokes.size());
  for (const Stroke& s : strokes)
    vertices.push_back({s.a, s.b, s.depthA, s.depthB, s.tolerance, kindOf(s), s.outwardA,
                        s.outwardB, s.moveA, s.moveB, s.halfWidthA, s.halfWidthB, s.opacityA,
                        s.opacityB, s.capA, s.capB});
  m_segments.stream(std::as_bytes(std::span(vertices)));
}

void InkPass::draw(gpu::Device& device, const gpu::Target& target, const gpu::Texture& surfaceDepth,
                   const InkDraw& draw) {
  if (draw.count == 0)
    return;
  const bool grained = draw.grain > 0.0f && m_grained[std::size_t(draw.kind)];
  gpu::Program& program = *(grained ? m_grained : m_programs)[std::size_t(draw.kind)];
  program.set("layer", glm::vec4(float(draw.layer.x), float(draw.layer.y), float(draw.layer.width),
                                 float(draw.layer.height)));
  program.set("surfaceDepth", surfaceDepth);
  program.set("surfaceStep", float(draw.surfaceStep));
  program.set("slot",
              glm::ivec4(draw.slot.x, draw.slot.y, draw.slot.right() - 1, draw.slot.top() - 1));
  program.set("toAtlas", glm::ivec2(draw.slot.x - draw.layer.x, draw.slot.y - draw.layer.y));
  if (draw.kind != InkKind::trims)
    program.set("projection", draw.projection);
  if (draw.kind != InkKind::surfaceLines && draw.kind != InkKind::trims) {
    program.set("reach", draw.reach);
    program.set("sheet", draw.sheet);
  }
  const bool outlines = draw.kind == InkKind::contours || draw.kind == InkKind::hidden;
  if (outlines) {
    program.set("probe", draw.probe);
    program.set("channel", draw.kind == InkKind::contours ? glm::vec2(1.0f, 0.0f)
                                                          : glm::vec2(0.0f, hiddenCoverage));
  }
  if (grained)
    program.set("grain", glm::vec2(draw.grain, draw.grainSize));
  if (draw.kind == InkKind::edges) {
    program.set("paint", draw.paint);
    program.set("key", draw.key);
  }
  m_geometry.startInstancesAt(draw.first);
  // Segments come farthest first, so the depth that remains is the nearest line's although every
  // coverage counts.
  const bool trims = draw.kind == InkKind::trims;
  const gpu::DrawState state{.viewport = draw.slot,
                             .scissor = draw.slot,
                             .depth = trims ? gpu::DepthTest::off : gpu::DepthTest::always,
                             .writeDepth = !trims && draw.kind != InkKind::hidden,
                             .blend = blendOf(draw.kind)};
  device.quads({target, program, m_geometry, state}, draw.count);
}

}  // namespace sline::render::passes
