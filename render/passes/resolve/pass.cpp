// SPDX-License-Identifier: Apache-2.0
#include "render/passes/resolve/pass.h"

#include <algorithm>
#include <cassert>

#include "render/passes/shader_files.h"

namespace sline::render::passes {

namespace {

constexpr int filledFlag = 1 << 24;
constexpr int inkedFlag = 1 << 25;

std::int32_t pair(int low, int high) {
  assert(low >= 0 && low <= 0xffff && high >= 0 && high <= 0xffff);
  return std::int32_t(std::uint32_t(low) | std::uint32_t(high) << 16);
}

gpu::ProgramRecipe recipe() {
  using gpu::UniformType;
  return {.name = "resolve",
          .vertexFile = "resolve.vert.glsl",
          .fragmentFile = "resolve.frag.glsl",
          .uniforms = {{"targetSize", UniformType::vec2},
                       {"tileSide", UniformType::real},
                       {"colours", UniformType::texture},
                       {"inks", UniformType::texture},
                       {"depths", UniformType::texture},
                       {"entries", UniformType::intTexture},
                       {"entriesPerRow", UniformType::integer},
                       {"background", UniformType::vec4}}};
}

}  // namespace

ResolveEntry resolveEntry(const ResolveLayer& layer) {
  const gpu::Rect& a = layer.area;
  const int ink = layer.ink.red << 16 | layer.ink.green << 8 | layer.ink.blue;
  return {{pair(layer.offsetX + 32768, layer.offsetY + 32768), pair(a.x, a.right() - 1),
           pair(a.y, a.top() - 1),
           ink | (layer.filled ? filledFlag : 0) | (layer.inked ? inkedFlag : 0)}};
}

ResolvePass::ResolvePass()
    : m_tiles(gpu::BufferKind::vertices, "tiles"),
      m_geometry({{.buffer = &m_tiles,
                   .stride = sizeof(ResolveTile),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0}},
                   .perInstance = true}},
                 nullptr, "tiles") {}

Result<std::unique_ptr<ResolvePass>> ResolvePass::create(gpu::Dialect dialect) {
  auto program = gpu::Program::create(shaderFiles(), dialect, recipe());
  if (!program)
    return program.error();
  std::unique_ptr<ResolvePass> pass(new ResolvePass);
  pass->m_program = std::move(*program);
  return pass;
}

void ResolvePass::upload(std::span<const ResolveTile> tiles,
                         std::span<const ResolveEntry> entries) {
  m_tiles.stream(std::as_bytes(tiles));
  m_tileCount = tiles.size();
  const int rows = std::max(1, (int(entries.size()) + entriesPerRow - 1) / entriesPerRow);
  if (!m_entries || m_entries->size().height < rows)
    m_entries = std::make_unique<gpu::Texture>(gpu::TextureFormat::rgba32i,
                                               gpu::TextureSize{entriesPerRow, rows + rows / 2},
                                               "layers of tiles");
  m_rows.assign(std::size_t(rows) * entriesPerRow, ResolveEntry{});
  std::copy(entries.begin(), entries.end(), m_rows.begin());
  m_entries->upload(std::as_bytes(std::span(m_rows)), rows);
}

void ResolvePass::draw(gpu::Device& device, const gpu::Target& target,
                       const ResolveInputs& inputs) const {
  const gpu::TextureSize size = target.size();
  device.clear(target, {.colour = inputs.background});
  if (m_tileCount == 0)
    return;
  m_program->set("targetSize", glm::vec2(float(size.width), float(size.height)));
  m_program->set("tileSide", float(tileSide));
  m_program->set("colours", inputs.colours);
  m_program->set("inks", inputs.inks);
  m_program->set("depths", inputs.depths);
  m_program->set("entries", *m_entries);
  m_program->set("entriesPerRow", entriesPerRow);
  m_program->set("background", inputs.background);
  const gpu::DrawState state{.viewport = {0, 0, size.width, size.height}};
  device.quads({target, *m_program, m_geometry, state}, m_tileCount);
}

}  // namespace sline::render::passes
