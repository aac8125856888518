// SPDX-License-Identifier: Apache-2.0
// Draws hatching as S prints it into the ink of layers. Programs and textures are made when a
// picture first asks for it.
#pragma once

#include "render/passes/hatching/hatching_pass.h"
#include "render/picture/atlas.h"
#include "render/picture/layer.h"

namespace sline::render {

/// Tells whether a structure of that style is hatched as S prints it.
bool showsPrintedHatching(const model::ResolvedStyle& style, const PictureSettings& settings);
/// Returns the pixels around a region in which a search that starts within it may end.
int printedHatchingReach(const PictureView& view);

class PrintedHatching {
 public:
  /// Hatches those of the changed layers that need it, after their surfaces have been drawn. The
  /// error says what the driver lacks.
  Status draw(gpu::Device& device, const PictureView& view, const Atlas& atlas,
              std::span<const Layer> layers, std::span<const std::size_t> changed);

 private:
  Status prepare(const gpu::Device& device, gpu::TextureSize size);

  std::unique_ptr<passes::HatchingPass> m_pass;
  std::unique_ptr<gpu::Texture> m_fields;
  std::unique_ptr<gpu::Texture> m_depths;
  std::unique_ptr<gpu::Target> m_target;
};

}  // namespace sline::render
