// SPDX-License-Identifier: Apache-2.0
#include "render/passes/resolve/resolve_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/gpu/draw_queue.h"
#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

constexpr int filledFlag = 1 << 24;
constexpr int inkedFlag = 1 << 25;
constexpr int hiddenFlag = 1 << 26;
constexpr int haloFlag = 1 << 27;

std::int32_t pair(int low, int high) {
  assert(low >= 0 && low <= 0xffff && high >= 0 && high <= 0xffff);
  return std::int32_t(std::uint32_t(low) | std::uint32_t(high) << 16);
}

gpu::ProgramRecipe resolveRecipe() {
  using gpu::UniformType;
  return {.name = "resolve",
          .vertexFile = "resolve.vert.glsl",
          .fragmentFile = "resolve.frag.glsl",
          .uniforms = {{"targetSize", UniformType::vec2},
                       {"colours", UniformType::texture},
                       {"inks", UniformType::texture},
                       {"depths", UniformType::texture},
                       {"offsets", UniformType::intTexture},
                       {"looks", UniformType::intTexture},
                       {"rowBits", UniformType::integer},
                       {"hiddenLines", UniformType::integer},
                       {"background", UniformType::vec4}}};
}

gpu::ProgramRecipe outlineRecipe() {
  using gpu::UniformType;
  return {.name = "outline",
          .vertexFile = "resolve.vert.glsl",
          .fragmentFile = "outline.frag.glsl",
          .uniforms = {{"targetSize", UniformType::vec2},
                       {"numbers", UniformType::texture},
                       {"numberDepths", UniformType::texture},
                       {"colours", UniformType::texture},
                       {"depths", UniformType::texture},
                       {"offsets", UniformType::intTexture},
                       {"looks", UniformType::intTexture},
                       {"rowBits", UniformType::integer},
                       {"corner", UniformType::ivec2},
                       {"ink", UniformType::vec3},
                       {"casing", UniformType::vec3},
                       {"pen", UniformType::vec4},
                       {"scale", UniformType::real},
                       {"reach", UniformType::integer}}};
}

}  // namespace

ResolveEntry resolveEntry(const ResolveLayer& layer) {
  const int ink = layer.ink.red << 16 | layer.ink.green << 8 | layer.ink.blue;
  return {.offset = pair(layer.offsetX + 32768, layer.offsetY + 32768),
          .look = ink | (layer.filled ? filledFlag : 0) | (layer.inked ? inkedFlag : 0) |
                  (layer.hiddenInk ? hiddenFlag : 0) | (layer.haloed ? haloFlag : 0)};
}

ResolveTile resolveTile(const PixelRect& rectangle, std::span<const ResolveEntry> entries,
                        std::size_t first) {
  ResolveTile tile{.corner = pair(rectangle.x, rectangle.y),
                   .size = pair(rectangle.width, rectangle.height),
                   .first = std::int32_t(first),
                   .count = std::int32_t(entries.size() - first)};
  for (std::size_t i = 0; i < tile.offsets.size() && first + i < entries.size(); ++i)
    tile.offsets[i] = entries[first + i].offset;
  return tile;
}

ResolvePass::ResolvePass()
    : m_tiles(gpu::BufferKind::vertices, "tiles"),
      m_geometry({{.buffer = &m_tiles,
                   .stride = sizeof(ResolveTile),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0},
                                  {1, 4, gpu::AttributeType::integer32, 16},
                                  {2, 4, gpu::AttributeType::integer32, 32},
                                  {3, 4, gpu::AttributeType::integer32, 48}},
                   .perInstance = true}},
                 nullptr, "tiles") {}

Result<std::unique_ptr<ResolvePass>> ResolvePass::create(gpu::Dialect dialect) {
  auto program = TRY(gpu::Program::create(shaderFiles(), dialect, resolveRecipe()));
  std::unique_ptr<ResolvePass> pass(new ResolvePass);
  pass->m_program = std::move(program);
  gpu::ProgramRecipe oneRecipe = resolveRecipe();
  oneRecipe.name = "resolve one layer";
  oneRecipe.fragmentFile = "resolve_one.frag.glsl";
  pass->m_one = TRY(gpu::Program::create(shaderFiles(), dialect, oneRecipe));
  pass->m_outline = TRY(gpu::Program::create(shaderFiles(), dialect, outlineRecipe()));
  return pass;
}

Status ResolvePass::upload(std::span<const ResolveTile> tiles,
                           std::span<const ResolveEntry> entries) {
  std::vector<ResolveTile> sorted(tiles.begin(), tiles.end());
  const auto others = std::stable_partition(
      sorted.begin(), sorted.end(), [](const ResolveTile& tile) { return tile.count == 1; });
  m_singles = std::size_t(others - sorted.begin());
  m_tiles.stream(std::as_bytes(std::span(sorted)));
  m_batches.clear();
  int waiting = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    waiting += sorted[i].count;
    if (waiting >= gpu::DrawQueue::mostLayersOfTiles || i + 1 == sorted.size() ||
        i + 1 == m_singles) {
      m_batches.push_back(i + 1);
      waiting = 0;
    }
  }
  const int rows = std::max(1, (int(entries.size()) + entriesPerRow - 1) / entriesPerRow);
  if (!m_offsets || m_offsets->size().height < rows) {
    const gpu::TextureSize size{entriesPerRow, rows + rows / 2};
    m_offsets = std::make_unique<gpu::Texture>(gpu::TextureFormat::r32i, size, "places of layers");
    m_looks = std::make_unique<gpu::Texture>(gpu::TextureFormat::r32i, size, "looks of layers");
  }
  std::vector<std::int32_t> offsets(std::size_t(rows) * entriesPerRow);
  std::vector<std::int32_t> looks(offsets.size());
  m_hiddenLines = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    offsets[i] = entries[i].offset;
    looks[i] = entries[i].look;
    m_hiddenLines = m_hiddenLines || (entries[i].look & hiddenFlag) != 0;
  }
  TRY(m_offsets->upload(std::as_bytes(std::span(offsets)), rows));
  return m_looks->upload(std::as_bytes(std::span(looks)), rows);
}

void ResolvePass::set(const gpu::Program& program, gpu::TextureSize size,
                      const ResolveInputs& inputs) const {
  program.set("targetSize", glm::vec2(float(size.width), float(size.height)));
  program.set("colours", inputs.colours);
  program.set("inks", inputs.inks);
  program.set("depths", inputs.depths);
  program.set("offsets", *m_offsets);
  program.set("looks", *m_looks);
  program.set("rowBits", rowBits);
  program.set("hiddenLines", m_hiddenLines ? 1 : 0);
  program.set("background", inputs.background);
}

void ResolvePass::draw(gpu::Device& device, const gpu::Target& target,
                       const ResolveInputs& inputs) {
  const gpu::TextureSize size = target.size();
  if (!inputs.keepOthers)
    device.clear(target, {.colour = inputs.background});
  if (m_batches.empty())
    return;
  set(*m_one, size, inputs);
  set(*m_program, size, inputs);
  drawTiles(device, target, {*m_one, *m_program}, {.viewport = {0, 0, size.width, size.height}});
}

void ResolvePass::drawTiles(gpu::Device& device, const gpu::Target& target,
                            const TilePrograms& programs, const gpu::DrawState& state) {
  gpu::DrawQueue queue(device.software());
  std::size_t first = 0;
  for (const std::size_t end : m_batches) {
    m_geometry.startInstancesAt(first);
    const gpu::Program& program = end <= m_singles ? programs.one : programs.others;
    device.quads({target, program, m_geometry, state}, end - first);
    queue.addLayersOfTiles(gpu::DrawQueue::mostLayersOfTiles);
    first = end;
  }
}

void ResolvePass::drawOutlines(gpu::Device& device, const gpu::Target& target,
                               const OutlineInputs& inputs) {
  if (m_batches.empty())
    return;
  const PixelRect& region = inputs.region;
  m_outline->set("targetSize", glm::vec2(float(region.width), float(region.height)));
  m_outline->set("numbers", inputs.numbers);
  m_outline->set("numberDepths", inputs.numberDepths);
  m_outline->set("colours", inputs.colours);
  m_outline->set("depths", inputs.depths);
  m_outline->set("offsets", *m_offsets);
  m_outline->set("looks", *m_looks);
  m_outline->set("rowBits", rowBits);
  m_outline->set("corner", glm::ivec2(region.x, region.y));
  const OutlineLook& look = inputs.look;
  m_outline->set("ink", look.ink);
  m_outline->set("casing", look.casing);
  m_outline->set(
      "pen", glm::vec4(look.halfWidth, look.casingHalfWidth, look.strength, look.hiddenStrength));
  m_outline->set("scale", look.scale());
  m_outline->set("reach", look.reach());
  drawTiles(device, target, {*m_outline, *m_outline},
            {.viewport = region, .scissor = region, .blend = gpu::Blend::over});
}

}  // namespace sline::render::passes
