// SPDX-License-Identifier: Apache-2.0
#include "render/picture/atlas.h"

#include <algorithm>
#include <numeric>

namespace sline::render {

namespace {

/// A common width and coarse steps of height keep the textures while a scene turns.
constexpr int usualWidth = 2048;
constexpr int sizeStep = 256;

}  // namespace

int roundedToStep(int pixels) {
  return (pixels + sizeStep - 1) / sizeStep * sizeStep;
}

std::vector<PixelRect> Atlas::layOut(std::span<const gpu::TextureSize> sizes, int surfaceStep) {
  m_surfaceStep = surfaceStep;
  std::size_t area = 0;
  int widest = 1;
  for (const gpu::TextureSize& size : sizes) {
    area += std::size_t(size.width) * size.height;
    widest = std::max(widest, size.width);
  }
  if (area > m_limits.pixels || widest > m_limits.side)
    return {};
  const int width = std::min(m_limits.side, std::max(usualWidth, roundedToStep(widest)));
  const int height = int(std::min<std::size_t>(m_limits.side, m_limits.pixels / width));
  // Rows fill best from the tallest to the lowest; the given order decides between equals.
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a].height > sizes[b].height; });
  ShelfPacker packer({width, height});
  std::vector<PixelRect> places(sizes.size());
  for (const std::size_t i : order) {
    const auto place = packer.place(sizes[i].width, sizes[i].height);
    if (!place)
      return {};
    places[i] = *place;
  }
  // Leaves some room for layers that change their size while the view stays.
  m_wanted = {width,
              std::min(height, roundedToStep(packer.usedHeight() + packer.usedHeight() / 8 + 1))};
  m_packer = packer;
  m_packer.limitHeight(m_wanted.height);
  return places;
}

bool Atlas::outgrown() const {
  const gpu::TextureSize now = m_colours ? m_colours->size() : gpu::TextureSize{};
  return now.width != m_wanted.width || now.height < m_wanted.height ||
         now.height > 2 * m_wanted.height;
}

bool Atlas::release() {
  const bool any = m_colours != nullptr;
  m_surfaceTarget.reset();
  m_inkTarget.reset();
  m_edgeTarget.reset();
  m_coarseTarget.reset();
  for (auto* texture :
       {&m_colours, &m_inks, &m_surfaceDepths, &m_layerDepths, &m_coarseColours, &m_coarseDepths})
    texture->reset();
  return any;
}

Status Atlas::allocate() {
  if (!m_colours)
    TRY(allocateFine());
  return coarse() && !m_coarseColours ? allocateCoarse() : Status(Unit{});
}

Status Atlas::allocateFine() {
  const auto make = [this](std::unique_ptr<gpu::Texture>& texture, gpu::TextureFormat format,
                           const char* name) {
    texture = std::make_unique<gpu::Texture>(format, m_wanted, name);
  };
  make(m_colours, m_limits.deep ? gpu::TextureFormat::rgba16 : gpu::TextureFormat::rgba8, "fills");
  make(m_inks, gpu::TextureFormat::rg8, "ink");
  make(m_surfaceDepths, gpu::TextureFormat::depth32f, "surface depth");
  make(m_layerDepths, gpu::TextureFormat::depth32f, "layer depth");
  m_surfaceTarget =
      TRY(gpu::Target::create({{m_colours.get()}, m_surfaceDepths.get()}, "surfaces"));
  m_inkTarget = TRY(gpu::Target::create({{m_inks.get()}, m_layerDepths.get()}, "ink"));
  m_edgeTarget = TRY(gpu::Target::create({{m_colours.get()}, m_layerDepths.get()}, "edges"));
  return Unit{};
}

Status Atlas::allocateCoarse() {
  // The smallest step needs the most; larger ones come and go without new textures.
  constexpr int smallest = 2;
  const gpu::TextureSize all = m_colours->size();
  const gpu::TextureSize size{(all.width + smallest - 1) / smallest,
                              (all.height + smallest - 1) / smallest};
  m_coarseColours = std::make_unique<gpu::Texture>(m_colours->format(), size, "coarse fills");
  m_coarseDepths =
      std::make_unique<gpu::Texture>(gpu::TextureFormat::depth32f, size, "coarse surface depth");
  m_coarseTarget =
      TRY(gpu::Target::create({{m_coarseColours.get()}, m_coarseDepths.get()}, "coarse"));
  return Unit{};
}

}  // namespace sline::render
