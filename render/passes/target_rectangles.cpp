// SPDX-License-Identifier: Apache-2.0
#include "render/passes/target_rectangles.h"

namespace sline::render::passes {

static_assert(sizeof(PixelRect) == 4 * sizeof(std::int32_t));

TargetRectangles::TargetRectangles(std::string_view name)
    : m_rectangles(gpu::BufferKind::vertices, name),
      m_geometry({{.buffer = &m_rectangles,
                   .stride = sizeof(PixelRect),
                   .attributes = {{0, 4, gpu::AttributeType::integer32, 0}},
                   .perInstance = true}},
                 nullptr, name) {}

void TargetRectangles::draw(gpu::Device& device, const gpu::Target& target, gpu::Program& program,
                            std::span<const PixelRect> rectangles, gpu::DrawState state) {
  const gpu::TextureSize size = target.size();
  m_rectangles.stream(std::as_bytes(rectangles));
  program.set("targetSize", glm::vec2(float(size.width), float(size.height)));
  state.viewport = {0, 0, size.width, size.height};
  device.quads({target, program, m_geometry, state}, rectangles.size());
}

}  // namespace sline::render::passes
