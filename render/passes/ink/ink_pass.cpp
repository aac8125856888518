// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ink/ink_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "render/passes/shader_files.h"
#include "render/sight/rules.h"

namespace sline::render::passes {

namespace {

/// Tells whether strokes of that kind go to the fills' target.
bool changesFills(InkKind kind) {
  return kind == InkKind::edges || kind == InkKind::trims;
}

bool isOutline(InkKind kind) {
  return kind == InkKind::contours || kind == InkKind::hidden;
}

/// Those of contour_strip.vert.glsl that others do not have.
std::array<gpu::Uniform, 3> stripUniforms() {
  return {{{"projection", gpu::UniformType::vec4},
           {"reach", gpu::UniformType::real},
           {"sheetInMm", gpu::UniformType::real}}};
}

gpu::ProgramRecipe inkRecipe(InkKind kind) {
  using gpu::UniformType;
  gpu::ProgramRecipe recipe{
      .name = "lines on surfaces",
      .vertexFile = "ink.vert.glsl",
      .fragmentFile = "surface_line.frag.glsl",
      .uniforms = {{"layer", UniformType::vec4}, {"toAtlas", UniformType::ivec2}}};
  if (kind != InkKind::surfaceLines) {
    recipe.uniforms.push_back({"surfaceDepth", UniformType::texture});
    recipe.uniforms.push_back({"surfaceStep", UniformType::real});
    recipe.uniforms.push_back({"slot", UniformType::ivec4});
  }
  if (kind == InkKind::trims) {
    recipe.name = "trims of fills";
    recipe.vertexFile = "contour_strip.vert.glsl";
    recipe.fragmentFile = "trim.frag.glsl";
    for (const gpu::Uniform& uniform : stripUniforms())
      recipe.uniforms.push_back(uniform);
    return recipe;
  }
  recipe.uniforms.push_back({"sights", UniformType::intTexture});
  recipe.uniforms.push_back({"first", UniformType::integer});
  recipe.uniforms.push_back({"projection", UniformType::vec4, !isOutline(kind)});
  if (kind == InkKind::surfaceLines)
    return recipe;
  if (isOutline(kind)) {
    recipe.name = kind == InkKind::contours ? "contours" : "hidden outlines";
    recipe.fragmentFile = "contour.frag.glsl";
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
  if (kind == InkKind::halos || changesFills(kind))
    return std::nullopt;
  gpu::ProgramRecipe recipe = inkRecipe(kind);
  recipe.fragmentFile = kind == InkKind::surfaceLines ? "surface_line_grained.frag.glsl"
                                                      : "contour_grained.frag.glsl";
  recipe.uniforms.push_back({"grain", gpu::UniformType::vec2});
  return recipe;
}

gpu::ProgramRecipe sightRecipe() {
  using gpu::UniformType;
  return {.name = "lines in sight",
          .vertexFile = "hatching_search.vert.glsl",
          .fragmentFile = "sight.frag.glsl",
          .uniforms = {{"strokes", UniformType::texture},
                       {"looks", UniformType::texture},
                       {"surfaceDepth", UniformType::texture},
                       {"surfaceStep", UniformType::real},
                       {"projection", UniformType::vec4}}};
}

gpu::ProgramRecipe fillUpRecipe() {
  using gpu::UniformType;
  gpu::ProgramRecipe recipe{.name = "fills up to contours",
                            .vertexFile = "contour_strip.vert.glsl",
                            .fragmentFile = "fill_up.frag.glsl",
                            .uniforms = {{"layer", UniformType::vec4},
                                         {"toAtlas", UniformType::ivec2},
                                         {"slot", UniformType::ivec4},
                                         {"colours", UniformType::texture},
                                         {"depths", UniformType::texture},
                                         {"pixelStep", UniformType::real}}};
  for (const gpu::Uniform& uniform : stripUniforms())
    recipe.uniforms.push_back(uniform);
  return recipe;
}

/// Sets where the layer lies.
void setPlace(const gpu::Program& program, const InkDraw& draw) {
  program.set("layer", glm::vec4(float(draw.layer.x), float(draw.layer.y), float(draw.layer.width),
                                 float(draw.layer.height)));
  program.set("toAtlas", glm::ivec2(draw.slot.x - draw.layer.x, draw.slot.y - draw.layer.y));
}

void setStrip(const gpu::Program& program, const InkDraw& draw) {
  program.set("projection", draw.projection);
  program.set("reach", float(draw.surfaceStep) + 0.5f);
  program.set("sheetInMm", draw.sheet);
}

glm::ivec4 firstAndLast(const PixelRect& slot) {
  return {slot.x, slot.y, slot.right() - 1, slot.top() - 1};
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
                          {5, 3, AttributeType::float32, offsetof(InkVertex, capA)}},
           .perInstance = true}};
}

}  // namespace

InkPass::InkPass()
    : m_segments(gpu::BufferKind::vertices, "ink segments"),
      m_geometry(streams(m_segments), nullptr, "ink"),
      m_rectangle({}, nullptr, "rectangle") {}

Result<std::unique_ptr<InkPass>> InkPass::create(gpu::Dialect dialect) {
  std::unique_ptr<InkPass> pass(new InkPass);
  pass->m_sight = TRY(gpu::Program::create(shaderFiles(), dialect, sightRecipe()));
  pass->m_fillUp = TRY(gpu::Program::create(shaderFiles(), dialect, fillUpRecipe()));
  for (std::size_t i = 0; i < inkKindCount; ++i) {
    const auto kind = InkKind(i);
    auto program = TRY(gpu::Program::create(shaderFiles(), dialect, inkRecipe(kind)));
    pass->m_programs[i] = std::move(program);
    if (const auto recipe = grainedRecipe(kind)) {
      auto grained = TRY(gpu::Program::create(shaderFiles(), dialect, *recipe));
      pass->m_grained[i] = std::move(grained);
    }
  }
  return pass;
}

Status InkPass::draw(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
                     std::span<const InkDraw> draws) {
  gpu::DrawQueue queue(device.software());
  m_batch.clear();
  for (const InkDraw& draw : draws)
    for (const Stroke& stroke : draw.strokes) {
      const int pieces = inkPieces(stroke);
      for (int piece = 0; piece < pieces; ++piece) {
        if (m_batch.full()) {
          TRY(drawBatch(device, targets, surfaces, queue));
          m_batch.clear();
        }
        m_batch.add(draw, pieces == 1 ? stroke : inkPiece(stroke, piece, pieces));
      }
    }
  return drawBatch(device, targets, surfaces, queue);
}

Status InkPass::drawBatch(gpu::Device& device, const InkTargets& targets,
                          const InkSurfaces& surfaces, gpu::DrawQueue& queue) {
  if (m_batch.empty())
    return Unit{};
  m_segments.stream(std::as_bytes(m_batch.vertices()));
  const auto strokes = m_batch.strokeTexels();
  const auto looks = m_batch.lookTexels();
  TRY(makeRoom(InkBatch::rowsOf(strokes), InkBatch::rowsOf(looks)));
  TRY(m_strokes->upload(std::as_bytes(strokes), InkBatch::rowsOf(strokes)));
  TRY(m_looks->upload(std::as_bytes(looks), InkBatch::rowsOf(looks)));
  findSights(device, surfaces.depths, queue);
  for (InkBatch::Run run : m_batch.runs()) {
    const std::size_t end = run.first + run.count;
    for (; run.first < end; run.first += run.count) {
      run.count = std::min(end - run.first, gpu::DrawQueue::mostStrokes);
      if (run.draw->kind == InkKind::trims && surfaces.enlarged)
        fillUp(device, targets, surfaces, run);
      drawRun(device, targets, surfaces, run);
      queue.addStrokes(run.count);
    }
  }
  return Unit{};
}

Status InkPass::makeRoom(int strokeRows, int lookRows) {
  const auto grown = [](int rows) { return std::min(rows + rows / 2, InkBatch::mostRows); };
  if (!m_looks || m_looks->size().height < lookRows)
    m_looks = std::make_unique<gpu::Texture>(gpu::TextureFormat::rgba32f,
                                             gpu::TextureSize{InkBatch::rowTexels, grown(lookRows)},
                                             "looks of lines");
  if (m_strokes && m_strokes->size().height >= strokeRows)
    return Unit{};
  const int rows = grown(strokeRows);
  m_sightTarget.reset();
  m_strokes = std::make_unique<gpu::Texture>(
      gpu::TextureFormat::rgba32f, gpu::TextureSize{InkBatch::rowTexels, rows}, "strokes");
  m_sights = std::make_unique<gpu::Texture>(
      gpu::TextureFormat::r32i, gpu::TextureSize{InkBatch::perRow, rows}, "lines in sight");
  m_sightTarget = TRY(gpu::Target::create({{m_sights.get()}, nullptr}, "lines in sight"));
  return Unit{};
}

void InkPass::findSights(gpu::Device& device, const gpu::Texture& surfaceDepth,
                         gpu::DrawQueue& queue) {
  constexpr int rowsAtOnce = 128;
  m_sight->set("strokes", *m_strokes);
  m_sight->set("looks", *m_looks);
  m_sight->set("surfaceDepth", surfaceDepth);
  m_sight->set("surfaceStep", float(m_batch.runs().front().draw->surfaceStep));
  m_sight->set("projection", m_batch.runs().front().draw->projection);
  const int rows = InkBatch::rowsOf(m_batch.strokeTexels());
  for (int row = 0; row < rows; row += rowsAtOnce) {
    const PixelRect here{0, row, InkBatch::perRow, std::min(rowsAtOnce, rows - row)};
    device.quads({*m_sightTarget, *m_sight, m_rectangle, {.viewport = here, .scissor = here}}, 1);
    queue.addSights(std::size_t(here.width) * std::size_t(here.height));
  }
}

void InkPass::fillUp(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
                     const InkBatch::Run& run) {
  const InkDraw& draw = *run.draw;
  setPlace(*m_fillUp, draw);
  m_fillUp->set("slot", firstAndLast(draw.slot));
  setStrip(*m_fillUp, draw);
  m_fillUp->set("colours", *surfaces.enlarged);
  m_fillUp->set("depths", surfaces.depths);
  m_fillUp->set("pixelStep", float(draw.surfaceStep));
  m_geometry.startInstancesAt(run.first);
  device.quads({targets.fills,
                *m_fillUp,
                m_geometry,
                {.viewport = draw.slot,
                 .scissor = draw.slot,
                 .depth = gpu::DepthTest::always,
                 .writeDepth = true}},
               run.count);
}

void InkPass::drawRun(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
                      const InkBatch::Run& run) {
  const InkDraw& draw = *run.draw;
  const bool grained = draw.grain > 0.0f && m_grained[std::size_t(draw.kind)];
  gpu::Program& program = *(grained ? m_grained : m_programs)[std::size_t(draw.kind)];
  setPlace(program, draw);
  const bool trims = draw.kind == InkKind::trims;
  if (trims) {
    setStrip(program, draw);
  } else {
    program.set("sights", *m_sights);
    program.set("first", int(run.first));
    program.set("projection", draw.projection);
  }
  if (draw.kind != InkKind::surfaceLines) {
    program.set("surfaceDepth", surfaces.depths);
    program.set("surfaceStep", float(draw.surfaceStep));
    program.set("slot", firstAndLast(draw.slot));
  }
  if (isOutline(draw.kind)) {
    program.set("channel", draw.kind == InkKind::contours ? glm::vec2(1.0f, 0.0f)
                                                          : glm::vec2(0.0f, rule::hiddenStored));
  }
  if (grained)
    program.set("grain", glm::vec2(draw.grain, draw.grainSize));
  if (draw.kind == InkKind::edges) {
    program.set("paint", draw.paint);
    program.set("key", draw.key);
  }
  m_geometry.startInstancesAt(run.first);
  // Segments come farthest first, so the depth that remains is the nearest line's although every
  // coverage counts.
  const gpu::DrawState state{.viewport = draw.slot,
                             .scissor = draw.slot,
                             .depth = trims ? gpu::DepthTest::off : gpu::DepthTest::always,
                             .writeDepth = !trims && draw.kind != InkKind::hidden,
                             .blend = blendOf(draw.kind)};
  device.quads({changesFills(draw.kind) ? targets.fills : targets.ink, program, m_geometry, state},
               run.count);
}

}  // namespace sline::render::passes
